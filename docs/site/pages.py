"""Puts the sources of the book together: pages/ with the Markdown of the repository, its links turned to the book's pages.

    python docs/site/pages.py FOLDER

GitHub shows the same files. So a link between pages becomes one between the book's pages, a picture is copied, formulas get Sphinx's marks, and a link to
a file that is no page leads to the repository that Cargo.toml names; while it names none, the file's path is shown instead.
"""

import os
import re
import shutil
import sys
import tomllib
from pathlib import Path

from contents import FRONT, PARTS, TITLES
from fences import FENCE
from stability import case_pages

ROOT = Path(__file__).parents[2]
FRONT_SOURCE = "docs/site/front.md"
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\[\]]*\])*)\]\(([^()\s]+)\)")
COMMENT = re.compile(r"<!--.*?-->\n?", re.S)
FORMULA = re.compile(r"\$`([^`]+)`\$")


def places() -> dict[str, str]:
    """Place in the book of each source."""
    pages = {source: place for _, part in PARTS for place, source in part}
    return pages | dict.fromkeys(FRONT, "index")


def repository() -> str | None:
    """Address of the repository, if Cargo.toml has one."""
    manifest = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))
    package = manifest.get("package", {}).get("repository")
    return package if isinstance(package, str) else manifest.get("workspace", {}).get("package", {}).get("repository")


class Staging:
    """The folder in which Sphinx finds the pages."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.places = places()
        self.repository = repository()

    def link(self, match: re.Match, source: str, place: str) -> str:
        """A link as the book has it."""
        picture, text, target = match.groups()
        if re.match(r"[a-z]+:", target) or target.startswith("#"):
            return match[0]
        path, _, anchor = target.partition("#")
        inside = os.path.normpath(os.path.join(os.path.dirname(source), path))
        if not (ROOT / inside).exists():
            raise SystemExit(f"{source}: there is no {inside}, to which a link leads; mend the link")
        if picture:
            self.copy(inside)
            return f"![{text}]({self.relative(inside, place)})"
        page = self.places.get(inside)
        if page is not None:
            return f"[{text}]({self.relative(page + '.md', place)}{'#' + anchor if anchor else ''})"
        if self.repository:
            return f"[{text}]({self.repository}/blob/main/{inside})"
        return text if Path(inside).name in text or inside in text else f"{text} (`{inside}`)"

    @staticmethod
    def relative(path: str, place: str) -> str:
        return os.path.relpath(path, os.path.dirname(place) or ".")

    def copy(self, picture: str) -> None:
        target = self.folder / picture
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / picture, target)

    def prose(self, text: str, source: str, place: str) -> str:
        """Text outside of fences."""
        text = COMMENT.sub(lambda match: "\n" if match[0].endswith("\n") and "=" not in match[0] else "", text)
        text = LINK.sub(lambda match: self.link(match, source, place), text)
        return FORMULA.sub(r"{math}`\1`", text)

    def convert(self, text: str, source: str, place: str) -> str:
        """A page of the repository as a page of the book."""
        pieces, end = [], 0
        for fence in FENCE.finditer(text):
            pieces.append(self.prose(text[end:fence.start()], source, place))
            ticks, language, body = fence.groups()
            if language == "math":
                pieces.append(f"{ticks}{{math}}\n\n{body}{ticks}\n")
            else:
                pieces.append(f"{ticks}{(language.split() or [''])[0]}\n{body}{ticks}\n")
            end = fence.end()
        pieces.append(self.prose(text[end:], source, place))
        return "".join(pieces)

    def write(self, place: str, text: str) -> None:
        target = self.folder / f"{place}.md"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")

    def fill(self) -> None:
        """Writes all pages."""
        shutil.rmtree(self.folder, ignore_errors=True)
        cases = case_pages(ROOT)
        for _, part in PARTS:
            for place, source in part:
                text = self.convert((ROOT / source).read_text(encoding="utf-8"), source, place)
                if place == "stability":
                    for name in cases:
                        text = text.replace(f"| `{name}` |", f"| [`{name}`](stability/{name}.md) |")
                    text += "\n## Case by case\n\n" + toctree([f"stability/{name}" for name in cases], "")
                self.write(place, text)
        for name, text in cases.items():
            self.write(f"stability/{name}", text)
        front = self.convert((ROOT / FRONT_SOURCE).read_text(encoding="utf-8"), FRONT_SOURCE, "index")
        self.write("index", front + "".join(toctree([place for place, _ in part], title) for title, part in PARTS))


def toctree(pages: list[str], title: str) -> str:
    """A list of pages, for Sphinx."""
    options = f":caption: {title}\n:hidden:\n" if title else ":maxdepth: 1\n"
    lines = [f"{TITLES[page]} <{page}>" if page in TITLES else page for page in pages]
    return "\n```{toctree}\n" + options + "\n" + "\n".join(lines) + "\n```\n"


if __name__ == "__main__":
    Staging(Path(sys.argv[1])).fill()
