"""Checks the built book: each link and picture leads to a file, each anchor to a place in it, and nothing to be loaded lies outside of the book.

    python docs/site/links.py SITE
"""

import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

#: Attributes whose target a browser loads by itself, by tag; links of other tags are followed by people.
LOADED = {"script": "src", "img": "src", "link": "href", "iframe": "src", "source": "src"}
#: Kinds of <link> that are only told.
TOLD = {"next", "prev", "index", "search", "canonical"}


class Page(HTMLParser):
    """Targets and anchors of a page."""

    def __init__(self, file: Path) -> None:
        super().__init__()
        self.anchors: set[str] = set()
        self.links: list[str] = []
        self.loaded: list[str] = []
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        found = dict(attributes)
        self.anchors.update(filter(None, (found.get("id"), found.get("name"))))
        target = found.get(LOADED.get(tag, "href"))
        if target is None:
            return
        loads = tag in LOADED and found.get("rel") not in TOLD
        (self.loaded if loads else self.links).append(target)


def main() -> None:
    site = Path(sys.argv[1]).resolve()
    pages = {file: Page(file) for file in site.rglob("*.html")}
    wrong, count = [], 0
    for file, page in pages.items():
        for target in page.links + page.loaded:
            parts = urlsplit(target)
            if parts.scheme or parts.netloc:
                if target in page.loaded and parts.scheme != "data":
                    wrong.append(f"{file.relative_to(site)}: loads {target}")
                continue
            count += 1
            aim = (file.parent / unquote(parts.path)).resolve() if parts.path else file
            if aim.is_dir():
                aim /= "index.html"
            if not aim.is_file():
                wrong.append(f"{file.relative_to(site)}: nothing is at {target}")
            elif parts.fragment and aim in pages and unquote(parts.fragment) not in pages[aim].anchors:
                wrong.append(f"{file.relative_to(site)}: no place {target}")
    print("\n".join(wrong) or f"{len(pages)} pages, {count} links within the book")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
