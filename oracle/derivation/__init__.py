"""The derivation that runs: `python -m oracle derivation` writes oracle/DERIVATION.md and oracle/figures/.

Every displayed formula is a tree (`notation`). One walk over the tree prints it, another computes it, and the value is compared
with its left side, which is found another way (`symbols` and the chapters). Then each formula is changed in every place, and each
change must be noticed.
"""

from pathlib import Path

FOLDER = Path(__file__).resolve().parent.parent
NAME = "oracle/DERIVATION.md"
PAGE, FIGURES = "DERIVATION.md", "figures"


def generate():
    """Texts of the page and of its pictures by path, once all formulas hold, all changes of them are noticed and each symbol means one thing."""
    from . import (choices, example, figures, force, glossary, inertia, interpolation, introduction, material, motion, position, speed, strain,
                   tangent)
    from .page import Page

    body = Page()
    for chapter in (position, interpolation, inertia, strain, material, force, tangent, motion, choices, speed, example):
        chapter.write(body)
    symbols = glossary.assert_single(body.printed)
    front = Page()
    introduction.write(front, *body.noticed(), symbols)
    pictures = {f"{FIGURES}/{name}": text for name, text in figures.texts().items()}
    return {PAGE: front.text() + "\n" + body.text()} | pictures


def write(texts):
    """Writes the files, each whole or not at all; returns the page's size in bytes."""
    (FOLDER / FIGURES).mkdir(exist_ok=True)
    for name, text in texts.items():
        place = FOLDER / name
        unfinished = place.with_suffix(".unfinished")
        unfinished.write_text(text, encoding="utf-8")
        unfinished.replace(place)
    return (FOLDER / PAGE).stat().st_size


def faults(texts):
    """Differences between the stored files and the texts, as lines that name the place."""
    found = [fault for name, text in texts.items() for fault in faults_of(name, text)]
    there = {f"{FIGURES}/{path.name}" for path in (FOLDER / FIGURES).glob("*")}
    return found + [f"oracle/{name}: the page does not make it" for name in sorted(there - set(texts))]


def faults_of(name, text):
    """Differences between a stored file and its text."""
    try:
        stored = (FOLDER / name).read_text(encoding="utf-8").split("\n")
    except (OSError, ValueError) as error:
        return [f"oracle/{name}: cannot be read: {error}"]
    fresh = text.split("\n")
    found = [f"oracle/{name}: line {k}: stored {a!r:.80}, made {b!r:.80}" for k, (a, b) in enumerate(zip(stored, fresh), 1) if a != b]
    if len(stored) != len(fresh):
        found.append(f"oracle/{name}: {len(stored)} lines stored, {len(fresh)} made")
    return found
