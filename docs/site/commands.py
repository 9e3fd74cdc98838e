"""Runs the commands that the book shows, and compares what they print with what the book says.

    python3 docs/site/commands.py PROGRAM [PAGE…]

PROGRAM is `ancf`. Each page is worked through in an empty folder of its own, with the repository beside it as `ancf/`. What stands behind ``` decides:

    sh run [TOOL…]      is run; needs the tools, and is skipped, and said, where one is missing
    sh fails [TOOL…]    likewise, and has to end with another exit code than 0
    sh install          installs something, which is not repeated here
    LANGUAGE FILE       the content of a file, which is written
    text printed        what the block before has printed: these lines, in this order; … stands for any text, and times may differ

A page of tutorials/ has no other block of commands, and at most 400 words before its first result. Needs Python 3.11 and nothing else.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from fences import FENCE

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = [DOCS / "first-picture.md", *sorted((DOCS / "tutorials").glob("*.md")), ROOT / "scenes/README.md",
         *(DOCS / f"{name}.md" for name in ("simulate", "accuracy", "many-runs"))]
MOST_WORDS = 400
SECONDS = 300
TIME = re.compile(r"\b\d+(\.\d+)? (s|ms|min)$", re.M)


def pattern(shown: str) -> re.Pattern:
    """What has to be found in a print: the shown lines, … for anything, spaces for any spaces."""
    pieces = []
    for line in TIME.sub("TIME", shown.strip()).splitlines():
        if line.strip() == "…":
            pieces.append(r"(?:.*\n)*?")
        else:
            words = [r"\s+".join(map(re.escape, part.split())) for part in line.split("…")]
            pieces.append(r"[ \t]*" + r".*?".join(words) + r"[ \t]*\n")
    return re.compile("".join(pieces))


class Page:
    """A page and the folder in which its commands run."""

    def __init__(self, file: Path, folder: Path, program: Path) -> None:
        self.name = file.relative_to(ROOT)
        self.text = file.read_text(encoding="utf-8")
        self.is_tutorial = file.parent.name == "tutorials"
        self.folder, self.printed = folder, None
        self.ran, self.skipped, self.compared = 0, [], 0
        tools = folder / "bin"
        tools.mkdir()
        (tools / "ancf").symlink_to(program)
        self.work = folder / "work"
        self.work.mkdir()
        (self.work / "ancf").symlink_to(ROOT)
        self.environment = os.environ | {"PATH": f"{tools}:{os.environ['PATH']}"}

    def wrong(self, message: str) -> SystemExit:
        return SystemExit(f"{self.name}: {message}")

    def run(self, commands: str, fails: bool, tools: list[str]) -> None:
        missing = [tool for tool in tools if shutil.which(tool) is None]
        if missing:
            self.printed = None
            self.skipped += missing
            return
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", commands], cwd=self.work, env=self.environment, text=True, encoding="utf-8",
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=SECONDS)
        if (done.returncode != 0) != fails:
            raise self.wrong(f"exit code {done.returncode} of\n{commands}{done.stdout}{done.stderr}")
        self.printed, self.ran = done.stdout + done.stderr, self.ran + 1

    def compare(self, shown: str) -> None:
        if self.printed is None:
            return
        if not pattern(shown).search(TIME.sub("TIME", self.printed) + "\n"):
            raise self.wrong(f"shows\n{shown}but printed is\n{self.printed}")
        self.compared += 1

    def words_before_result(self) -> int:
        """Words, code not counted, before the first shown result."""
        words, end = 0, 0
        for fence in FENCE.finditer(self.text):
            words += len(self.text[end:fence.start()].split())
            end = fence.end()
            if fence[2] == "text printed":
                return words
        raise self.wrong("shows no result; add a block ```text printed")

    def work_through(self) -> None:
        for _, marks, body in (fence.groups() for fence in FENCE.finditer(self.text)):
            language, *rest = marks.split() or [""]
            match language, rest:
                case "sh", ["run" | "fails" as how, *tools]:
                    self.run(body, how == "fails", tools)
                case "text", ["printed"]:
                    self.compare(body)
                case "sh", ["install"]:
                    pass
                case "sh", []:
                    if self.is_tutorial:
                        raise self.wrong("a block of commands is neither run, fails nor install")
                case _, [file]:
                    (self.work / file).write_text(body, encoding="utf-8")
        if self.is_tutorial and (words := self.words_before_result()) > MOST_WORDS:
            raise self.wrong(f"{words} words before the first result; at most {MOST_WORDS}")
        skipped = f", SKIPPED without {', '.join(dict.fromkeys(self.skipped))}" if self.skipped else ""
        print(f"{self.name}: {self.ran} blocks run, {self.compared} results as shown{skipped}")


def main() -> None:
    program = Path(sys.argv[1]).resolve()
    for file in [Path(name).resolve() for name in sys.argv[2:]] or PAGES:
        with tempfile.TemporaryDirectory() as folder:
            Page(file, Path(folder), program).work_through()


if __name__ == "__main__":
    main()
