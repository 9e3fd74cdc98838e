"""The derivation that runs: `python -m oracle derivation` writes oracle/DERIVATION.md.

Every displayed formula is a tree (`notation`). One walk over the tree prints it, another computes it, and the value is compared
with its left side, which is found another way (`symbols` and the chapters). Then each formula is changed in every place, and each
change must be noticed.
"""

from pathlib import Path

PLACE = Path(__file__).resolve().parent.parent / "DERIVATION.md"
NAME = "oracle/DERIVATION.md"


def generate():
    """Text of the page, once all formulas hold and all changes of them are noticed."""
    from . import choices, exercises, force, inertia, introduction, material, motion, position, speed, strain
    from .page import Page

    body = Page()
    for chapter in (position, inertia, strain, material, force, motion, choices, speed, exercises):
        chapter.write(body)
    front = Page()
    introduction.write(front, *body.noticed())
    return front.text() + "\n" + body.text()


def write(text):
    """Writes the page, whole or not at all; returns its size in bytes."""
    unfinished = PLACE.with_suffix(".unfinished")
    unfinished.write_text(text, encoding="utf-8")
    unfinished.replace(PLACE)
    return PLACE.stat().st_size


def faults(text):
    """Differences between the stored page and the text, as lines that name the place."""
    try:
        stored = PLACE.read_text(encoding="utf-8").split("\n")
    except (OSError, ValueError) as error:
        return [f"{NAME}: cannot be read: {error}"]
    fresh = text.split("\n")
    found = [f"{NAME}: line {k}: stored {a!r:.80}, made {b!r:.80}" for k, (a, b) in enumerate(zip(stored, fresh), 1) if a != b]
    if len(stored) != len(fresh):
        found.append(f"{NAME}: {len(stored)} lines stored, {len(fresh)} made")
    return found
