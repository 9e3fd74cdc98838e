"""The derivation that runs: `python -m oracle derivation` makes oracle/DERIVATION.md.

Every displayed formula is a tree that is written and computed by the same code (`notation`), and asserted against what its left side
is found to be another way (`symbols` and the chapters). Then each is changed, in every place, and the change must be noticed.
"""

from pathlib import Path

PLACE = Path(__file__).resolve().parent.parent / "DERIVATION.md"
NAME = "oracle/DERIVATION.md"


def generate():
    """The page's text, once everything on it holds and every change of it is noticed."""
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
    """Where the stored page is not the one that was made, as lines that name the place."""
    try:
        stored = PLACE.read_text(encoding="utf-8").split("\n")
    except (OSError, ValueError) as error:
        return [f"{NAME}: cannot be read: {error}"]
    fresh = text.split("\n")
    found = [f"{NAME}: line {k}: stored {a!r:.80}, made {b!r:.80}" for k, (a, b) in enumerate(zip(stored, fresh), 1) if a != b]
    if len(stored) != len(fresh):
        found.append(f"{NAME}: {len(stored)} lines stored, {len(fresh)} made")
    return found
