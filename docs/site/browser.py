"""Opens every page of the built book in a headless Chromium, as a static server shows it.

    python docs/site/browser.py SITE [--pictures FOLDER]

No fault on the console, no request beyond the book; every formula typeset; nothing wider than a phone; text legible in the light and in the dark;
the search finds; the keyboard reaches the contents. Needs the package of cli/tests/browser/requirements.txt. Exit code 77: there is no Chromium.
"""

import argparse
import functools
import http.server
import re
import sys
import tempfile
import threading
from pathlib import Path

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "cli/tests/browser"))

from devtools import Browser, browser_path  # noqa: E402

PHONE = 360
#: Least contrast of small text, WCAG 2 AA.
CONTRAST = 4.5
#: Pages with all that a page may have: tables, formulas, code, pictures.
SAMPLES = ("index", "derivation", "equations", "check", "scene-reference", "tutorials/two-rods", "stability", "stability/stiff-limit")

# Least contrast of the text of the page, and that text. Formulas and highlighted code are text like any other.
LEAST_CONTRAST = """(() => {
    const channels = (colour) => colour.match(/[\\d.]+/g).map(Number);
    const luminance = ([r, g, b]) => [r, g, b].map((c) => c / 255).map((c) => (c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
        .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
    const background = (element) => {
        for (let at = element; at; at = at.parentElement) {
            const colour = channels(getComputedStyle(at).backgroundColor);
            if (colour.length === 3 || colour[3] > 0.5) return colour;
        }
        return [255, 255, 255];
    };
    let least = [99, ""];
    const walk = document.createTreeWalker(document.querySelector("article"), NodeFilter.SHOW_TEXT);
    while (walk.nextNode()) {
        const element = walk.currentNode.parentElement, text = walk.currentNode.textContent.trim();
        if (!text || element.closest(".katex-mathml, .headerlink, svg") || !element.getClientRects().length) continue;
        const [a, b] = [getComputedStyle(element).color, background(element)].map((c) => luminance(typeof c === "string" ? channels(c) : c));
        const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        if (contrast < least[0]) least = [contrast, `${text.slice(0, 40)} (${element.tagName} ${element.className})`];
    }
    return least;
})()"""


class Quiet(http.server.SimpleHTTPRequestHandler):
    """A static server that says nothing."""

    def log_message(self, *_) -> None:
        pass


class Server:
    """A static server of a folder, while it is needed. Gives its address."""

    def __init__(self, folder: Path) -> None:
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(folder)))
        threading.Thread(target=self.server.serve_forever, daemon=True).start()

    def __enter__(self) -> str:
        return f"http://127.0.0.1:{self.server.server_port}/"

    def __exit__(self, *_) -> None:
        self.server.shutdown()
        self.server.server_close()


def check_quiet(browser: Browser, base: str, page: str) -> None:
    others = [url for url in browser.requests if not url.startswith((base, "data:"))]
    assert not browser.faults, f"{page}: the console has {browser.faults}"
    assert not others, f"{page}: asks for {others}"


def check_page(browser: Browser, base: str, page: str) -> int:
    """One page on a phone. Returns the number of its formulas."""
    browser.visit(f"{base}{page}.html")
    browser.run("document.fonts.ready.then(() => true)")
    wide = browser.run("document.documentElement.scrollWidth")
    assert wide <= PHONE, f"{page}: {wide} pixels wide on a phone"
    missing = browser.run("[...document.images].filter((image) => image.complete && !image.naturalWidth && image.loading !== 'lazy').map((image) => image.src)")
    assert not missing, f"{page}: pictures are missing: {missing}"
    assert browser.run("document.querySelectorAll('.katex-error').length") == 0, f"{page}: a formula is wrong"
    check_quiet(browser, base, page)
    return browser.run("document.querySelectorAll('.katex-html').length")


def check_formulas(browser: Browser, base: str, count: int) -> None:
    """As many as the source of the derivation has, in the fonts of the book."""
    text = (ROOT / "oracle/DERIVATION.md").read_text(encoding="utf-8")
    expected = len(re.findall(r"^```math$", text, re.M)) + len(re.findall(r"\$`[^`]+`\$", text))
    assert count == expected > 0, f"derivation: {count} formulas are typeset, its source has {expected}"
    browser.visit(f"{base}derivation.html")
    assert browser.run("document.fonts.ready.then(() => [...document.fonts].some((font) => font.family.includes('KaTeX_Math') && font.status === 'loaded'))"), \
        "derivation: the fonts of the formulas are not loaded"


def check_colours(browser: Browser, base: str) -> float:
    """Text is legible. Returns the least contrast."""
    least = 99.0
    grounds = {}
    for scheme in ("light", "dark"):
        browser.colours(scheme)
        for page in SAMPLES:
            browser.visit(f"{base}{page}.html")
            contrast, text = browser.run(LEAST_CONTRAST)
            assert contrast >= CONTRAST, f"{page}, {scheme}: a contrast of {contrast:.1f} at {text}"
            least = min(least, contrast)
        grounds[scheme] = browser.run("getComputedStyle(document.body).backgroundColor")
    assert grounds["light"] != grounds["dark"], f"the dark is light: {grounds}"
    browser.colours("light")
    return least


def check_search(browser: Browser, base: str) -> None:
    """The search finds words of different pages."""
    for word, page in (("polynomial", "derivation"), ("newton_tolerance", "scene-reference"), ("octave", "tutorials/check-octave")):
        browser.visit(f"{base}search.html?q={word}")
        for _ in range(100):
            found = browser.run("[...document.querySelectorAll('#search-results a')].map((link) => link.href)")
            if any(f"{page}.html" in link for link in found):
                break
            browser.run("new Promise((done) => setTimeout(done, 50))")
        else:
            raise AssertionError(f"the search for {word} finds {found}")
        check_quiet(browser, base, "search")


def check_keyboard(browser: Browser, base: str) -> None:
    """The first key leads to a link that skips the contents, and / to the search."""
    browser.screen(1200, 900)
    browser.visit(f"{base}index.html")
    browser.key("Tab", 9)
    first = browser.run("document.activeElement.textContent.trim()")
    assert "skip" in first.lower(), f"the first key leads to {first!r}"
    browser.visit(f"{base}derivation.html")
    assert browser.run("[...document.querySelectorAll('.formula')].every((formula) => formula.tabIndex === 0)"), "a wide formula cannot be moved by keys"


def check_that_faults_are_found(browser: Browser) -> None:
    """A page with a fault does not pass; the same without does."""
    faults = ("<script>console.error('wrong')</script>", "<img src='http://127.0.0.1:9/a.png'>", "<p style='width: 400px'>wide</p>",
              "<span class='katex-error'>x</span>", "<p style='color: #bbb'>pale</p>")
    with tempfile.TemporaryDirectory() as folder, Server(Path(folder)) as base:
        # A name of its own for each: the browser keeps a page of the same second.
        for number, fault in enumerate(("", *faults)):
            (Path(folder) / f"page{number}.html").write_text(f"<!doctype html><link rel='icon' href='data:,'><article><p>Text</p>{fault}</article>", encoding="utf-8")
            try:
                check_page(browser, base, f"page{number}")
                assert browser.run(LEAST_CONTRAST)[0] >= CONTRAST
            except AssertionError:
                assert fault, "a page without a fault does not pass"
            else:
                assert not fault, f"not noticed: {fault}"


def take_pictures(browser: Browser, base: str, folder: Path) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for page in (*SAMPLES, "first-picture"):
        for scheme, width in (("light", 1200), ("dark", 1200), ("light", PHONE)):
            browser.colours(scheme)
            browser.screen(width, 900)
            browser.visit(f"{base}{page}.html")
            browser.picture(folder / f"{page.replace('/', '-')}-{scheme}-{width}.png")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("site", type=Path)
    parser.add_argument("--pictures", type=Path, help="folder for pictures of some pages")
    arguments = parser.parse_args()
    path = browser_path()
    if path is None:
        print("there is no Chromium")
        sys.exit(77)
    site = arguments.site.resolve()
    with Browser(path) as browser, Server(site) as base:
        if arguments.pictures:
            take_pictures(browser, base, arguments.pictures)
        browser.screen(PHONE, 740)
        pages = sorted(str(file.relative_to(site).with_suffix("")) for file in site.rglob("*.html") if "_static" not in file.parts)
        formulas = {page: check_page(browser, base, page) for page in pages}
        check_formulas(browser, base, formulas["derivation"])
        check_search(browser, base)
        check_keyboard(browser, base)
        least = check_colours(browser, base)
        browser.screen(PHONE, 740)
        check_that_faults_are_found(browser)
    print(f"{len(pages)} pages, {sum(formulas.values())} formulas, least contrast {least:.1f}")


if __name__ == "__main__":
    main()
