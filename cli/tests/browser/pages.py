"""Opens the pages of runs in a headless Chromium, plays them, and compares what is drawn with the table of the run.

    python cli/tests/browser/pages.py target/release/ancf [--pictures FOLDER]

Fails on a console error, on a request, on a page that opens or plays too slowly. Exit code 77: there is no browser.
"""

import argparse
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

from devtools import Browser, browser_path

#: Longest time from the address to the first picture, s.
MOST_SECONDS = 2.0

#: Fewest pictures a second while playing.
FEWEST_PICTURES = 30

#: Largest page, bytes.
MOST_BYTES = 3_000_000

#: Error of a drawn position relative to the structure's size: displacements are counted in 10⁻⁷ of the largest.
POSITION = 2e-7

#: Values beside the charts have four digits: half of the last.
VALUE = 0.5e-3

PREFIXES = {"n": 1e-9, "µ": 1e-6, "m": 1e-3, "k": 1e3, "M": 1e6}

#: Scenes: the probed point, the number of charts, the least number of pixels by which the point moves.
SCENES = {
    "pendulum-flexible": ("a", "tip", 4, 60),
    "scissors-3-thermal": ("a4", "a4", 8, 60),
}

#: A scene that rests, whose displacements are magnified so that they show.
STATIC = "scissor-static"


def table(folder: Path) -> list[dict[str, float]]:
    """Rows of a run."""
    with (folder / "trajectory.csv").open() as lines:
        return [{name: float(number) for name, number in row.items()} for row in csv.DictReader(lines)]


def run(program: str, folder: Path, *arguments: str) -> Path:
    """Folder with the output of a run."""
    subprocess.run([program, "run", *arguments, "--out", str(folder)], check=True, stdout=subprocess.DEVNULL)
    return folder


def number(text: str) -> float:
    """A number as the page writes it: 0.5, −2, 1.5·10⁻⁷."""
    digits = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹−", "-0123456789-")
    mantissa, _, exponent = text.translate(digits).partition("·10")
    return float(mantissa) * 10.0 ** float(exponent or 0)


def scale(unit: str, base: str) -> float:
    """Size of a unit with a prefix, in units without."""
    return 1.0 if unit == base else PREFIXES[unit[0]]


def check_quiet(browser: Browser, page: Path) -> None:
    """Neither a fault nor a request beyond the page itself."""
    others = [url for url in browser.requests if url != page.resolve().as_uri() and not url.startswith("data:")]
    assert not browser.faults, f"{page}: the console has {browser.faults}"
    assert not others, f"{page}: asks for {others}"


def shown_value(browser: Browser, column: str) -> tuple[float, str]:
    """Value beside a chart, and its unit."""
    found = browser.run(f"""(() => {{
        const output = document.querySelector('output[data-column="{column}"]');
        return [output.textContent, output.closest(".values").lastElementChild.textContent];
    }})()""")
    return number(found[0]), found[1]


def check_values(browser: Browser, rows: list[dict[str, float]], point: str, probe: str) -> None:
    """What is drawn and written at some rows agrees with the table."""
    size = max(abs(row[f"{probe}.{axis}"]) for row in rows for axis in "xy")
    for row in (rows[0], rows[len(rows) // 3], rows[len(rows) // 2], rows[-1]):
        browser.run(f"ancfRun.seek({row['t']!r})")
        drawn = browser.run(f"ancfRun.position('{point}')")
        expected = [row[f"{probe}.{axis}"] for axis in "xy"]
        apart = math.dist(drawn, expected)
        assert apart <= POSITION * 4 * size, f"t = {row['t']}: {point} is drawn at {drawn}, not {expected}"
        for axis, value in zip("xy", expected):
            shown, unit = shown_value(browser, f"{probe}.{axis}")
            largest = max(abs(other[f"{probe}.{axis}"]) for other in rows)
            error = abs(shown * scale(unit, "m") - value)
            assert error <= VALUE * abs(value) + 1e-6 * largest, f"t = {row['t']}: {probe}.{axis} is shown as {shown} {unit}, not {value}"
        # The pixel there belongs to the structure, and not to the paper.
        pixel, paper = browser.run(f"""(() => {{
            const canvas = document.getElementById("stage"), ratio = canvas.width / canvas.clientWidth;
            // A copy to read from: reading the page's own canvas would slow it down.
            const copy = Object.assign(document.createElement("canvas"), {{ width: canvas.width, height: canvas.height }});
            const pen = copy.getContext("2d", {{ willReadFrequently: true }});
            pen.drawImage(canvas, 0, 0);
            const at = (x, y) => [...pen.getImageData(x * ratio, y * ratio, 1, 1).data];
            return [at(...ancfRun.screen('{point}')), at(1, 1)];
        }})()""")
        assert pixel != paper, f"t = {row['t']}: nothing is drawn at {point}"


def check_page(browser: Browser, name: str, folder: Path) -> None:
    """The page of a scene that moves."""
    point, probe, charts, pixels = SCENES[name]
    page, rows = folder / "report.html", table(folder)
    assert page.stat().st_size <= MOST_BYTES, f"{name}: {page.stat().st_size} bytes"
    browser.open(page)
    seconds = browser.run("performance.getEntriesByName('shown')[0].startTime") / 1000
    assert seconds <= MOST_SECONDS, f"{name}: {seconds:.2f} s until the first picture"

    assert browser.run("ancfRun.isPlaying"), f"{name}: does not play"
    # The best of three seconds: other programs use the machine, too.
    pictures = 0.0
    for _ in range(3):
        begin = browser.run("[ancfRun.drawn, ancfRun.time, performance.now()]")
        browser.run("new Promise((done) => setTimeout(done, 1000))")
        end = browser.run("[ancfRun.drawn, ancfRun.time, performance.now()]")
        assert end[1] != begin[1], f"{name}: the clock stands still"
        pictures = max(pictures, 1000 * (end[0] - begin[0]) / (end[2] - begin[2]))
    assert pictures >= FEWEST_PICTURES, f"{name}: {pictures:.0f} pictures a second"
    browser.key(" ", 32)
    assert not browser.run("ancfRun.isPlaying"), f"{name}: the space bar does not pause"

    # What is drawn moves.
    canvas = "document.getElementById('stage').toDataURL()"
    pictures_at, places = [], []
    for t in (0.0, 0.4 * rows[-1]["t"]):
        browser.run(f"ancfRun.seek({t})")
        pictures_at.append(browser.run(canvas))
        places.append(browser.run(f"ancfRun.screen('{point}')"))
    assert pictures_at[0] != pictures_at[1], f"{name}: nothing moves"
    assert math.dist(*places) >= pixels, f"{name}: {point} moves by {math.dist(*places):.0f} pixels"
    check_values(browser, rows, point, probe)

    # Charts are there, and lead the time.
    curves = browser.run("[...document.querySelectorAll('.chart')].map((chart) => chart.querySelectorAll('.curve').length)")
    assert len(curves) == charts and min(curves) > 0, f"{name}: curves {curves}"
    box = browser.run("""(() => {
        const svg = document.querySelector(".chart svg");
        svg.scrollIntoView({ block: "center" });
        const { left, top, width, height } = svg.getBoundingClientRect();
        return [left, top, width, height];
    })()""")
    browser.run("ancfRun.seek(0)")
    browser.click(box[0] + 0.5 * box[2], box[1] + 0.5 * box[3])
    share = browser.run("ancfRun.time") / rows[-1]["t"]
    assert 0.4 < share < 0.6, f"{name}: a click in the middle of a chart leads to {share:.2f} of the run"
    before = browser.run("document.querySelector('.chart svg').focus() ?? ancfRun.time")
    browser.key("ArrowRight", 39)
    assert browser.run("ancfRun.time") > before, f"{name}: the arrow key of a chart does nothing"

    # Every colour, magnified, in the dark, on a phone.
    for field in browser.run("[...document.getElementById('field').options].map((option) => option.value)"):
        browser.run(f"""(() => {{
            const select = document.getElementById("field");
            select.value = "{field}";
            select.dispatchEvent(new Event("change"));
        }})()""")
    light = browser.run("getComputedStyle(document.body).backgroundColor")
    browser.colours("dark")
    assert browser.run("getComputedStyle(document.body).backgroundColor") != light, f"{name}: the dark is light"
    browser.screen(360, 740)
    browser.run("new Promise((done) => setTimeout(done, 200))")
    wide = browser.run("document.scrollingElement.scrollWidth")
    assert wide <= 360, f"{name}: {wide} pixels wide on a phone"
    browser.colours("light")
    browser.screen(1200, 900)
    check_quiet(browser, page)
    print(f"{name}: {page.stat().st_size / 1e6:.2f} MB, first picture after {seconds:.2f} s, {pictures:.0f} pictures a second")


def check_static(browser: Browser, folder: Path) -> None:
    """Load steps play, magnified."""
    browser.open(folder / "report.html")
    assert browser.run("document.getElementById('clock').textContent").startswith("load factor")
    assert browser.run("document.getElementById('factor').textContent") != "×1", "a small displacement is not magnified"
    check_quiet(browser, folder / "report.html")


def check_main_page(browser: Browser, page: Path) -> None:
    """The main job's page: statements with numbers, their links, pictures with captions; legible on a phone."""
    browser.open(page)
    counts = browser.run("""[document.querySelectorAll('section.statement').length, document.querySelectorAll('figure svg').length,
        [...document.querySelectorAll('figure')].filter((figure) => figure.querySelector('figcaption')?.textContent.length > 20).length,
        [...document.querySelectorAll('a[href^="#"]')].filter((link) => !document.getElementById(link.hash.slice(1))).length]""")
    statements, pictures, captions, dead = counts
    assert statements == 21 and pictures == captions == 12 and dead == 0, f"{page.name}: {counts}"
    browser.screen(360, 740)
    wide = browser.run("document.documentElement.scrollWidth")
    assert wide <= 360, f"{page.name}: {wide} pixels wide on a phone"
    browser.screen(1200, 900)
    check_quiet(browser, page)
    print(f"{page.name}: {statements} statements, {pictures} pictures, {page.stat().st_size / 1e6:.2f} MB")


def check_that_faults_are_found(browser: Browser, page: Path, folder: Path) -> None:
    """A page with a fault, and one with a request, do not pass."""
    text = page.read_text(encoding="utf-8")
    policy = text[text.index("<meta http-equiv"):]
    for bad in ("<script>console.error('wrong')</script>", "<script>undefined.wrong()</script>",
                "<script>fetch('http://127.0.0.1:9/').catch(() => 0)</script>", "<img src='http://127.0.0.1:9/a.png'>"):
        broken = folder / "broken.html"
        # Without its policy the page may ask for what it wants.
        broken.write_text(text.replace(policy[:policy.index(">") + 1], "").replace("</body>", bad + "</body>"), encoding="utf-8")
        browser.open(broken)
        browser.run("new Promise((done) => setTimeout(done, 200))")
        try:
            check_quiet(browser, broken)
        except AssertionError:
            continue
        raise SystemExit(f"not noticed: {bad}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="the program ancf")
    parser.add_argument("--main", type=Path, help="paper.html of the main job, to be checked as well")
    parser.add_argument("--pictures", type=Path, help="folder for pictures of the pages")
    arguments = parser.parse_args()
    path = browser_path()
    if path is None:
        print("there is no Chromium")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as name, Browser(path) as browser:
        out = Path(name)
        browser.screen(1200, 900)
        for scene in SCENES:
            check_page(browser, scene, run(arguments.program, out / scene, scene))
        check_static(browser, run(arguments.program, out / STATIC, STATIC))
        if arguments.main:
            check_main_page(browser, arguments.main.resolve())
        first = out / next(iter(SCENES)) / "report.html"
        check_that_faults_are_found(browser, first, out)
        if arguments.pictures:
            take_pictures(browser, out, arguments.pictures)


def take_pictures(browser: Browser, out: Path, folder: Path) -> None:
    """Pictures of the pages as people see them."""
    folder.mkdir(parents=True, exist_ok=True)
    for scene in (*SCENES, STATIC):
        browser.open(out / scene / "report.html")
        for scheme, width in (("light", 1200), ("dark", 1200), ("light", 360)):
            browser.colours(scheme)
            browser.screen(width, 900)
            browser.run("ancfRun.pause() ?? new Promise((done) => setTimeout(done, 200))")
            browser.run("ancfRun.seek(0.45 * Number(document.getElementById('time').max))")
            browser.picture(folder / f"{scene}-{scheme}-{width}.png")


if __name__ == "__main__":
    main()
