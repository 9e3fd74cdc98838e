"""`oracle/README.md` against the files of this folder: it lists every module, and only modules that exist."""

import re
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
NAME = "oracle/README.md"
UNLISTED = {"__init__.py", "__main__.py"}


def modules():
    """Paths of all modules, relative to the folder; those that only open a package or a command are not listed."""
    paths = (path.relative_to(FOLDER) for path in FOLDER.rglob("*.py") if path.name not in UNLISTED)
    return sorted(path.as_posix() for path in paths)


def listed():
    """Paths in the first column of the page's tables: `element/field.py`, or the name alone under a folder's heading."""
    folder, found = "", []
    for line in (FOLDER / "README.md").read_text(encoding="utf-8").splitlines():
        if line.startswith("#"):
            heading = re.search(r"`(\w+/)`", line)
            folder = heading[1] if heading else ""
        elif line.startswith("| `"):
            found += [folder + name for name in re.findall(r"`([\w/]+\.py)`", line.split("|")[1])]
    return found


def faults():
    """Modules that the page leaves out, lists twice, or lists without there being any."""
    try:
        names = listed()
    except (OSError, ValueError) as error:
        return [f"{NAME}: cannot be read: {error}"]
    there = modules()
    found = [f"{NAME}: {name} is not listed" for name in there if name not in names]
    found += [f"{NAME}: {name} does not exist" for name in names if name not in there]
    return found + [f"{NAME}: {name} is listed twice" for name in sorted(set(names)) if names.count(name) > 1]
