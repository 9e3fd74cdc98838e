"""The page's beginning: what it is, how to read it, its symbols."""

from . import glossary


def write(page, formulas, changes, none, symbols):
    """The front matter, with the numbers of what was checked."""
    page.heading("The derivation that runs", 1)
    page.words("""From the polynomial (A.1) to the motion of pinned rods (23): the planar thermo-elastic beam of Peng,
        Wang, Li, Zhi and Li ([doi 10.1155/2018/1752815](https://doi.org/10.1155/2018/1752815)), in the paper's
        numbers. It asks for linear algebra and calculus of several variables; the paper is not needed.""")
    page.words(f"""**Every formula is executed.** A program (`python -m oracle derivation`, [source](derivation)) prints
        each from a tree, computes it from the same tree, and asserts that its sides are equal, whatever its symbols
        stand for; one of them is found another way, which *checked* under the formula tells. Then it makes small
        mistakes, one at a time: of {changes} in {formulas} formulas it noticed all but {none}, which change nothing.""")
    page.words("""Chapters: [position](#1-position-from-a-polynomial-to-shape-functions),
        [inertia](#2-inertia-a-mass-matrix-that-never-changes), [strain](#3-strain-what-deformation-is),
        [stress](#4-stress-hookes-law-for-large-motions), [forces](#5-energy-and-forces), [at rest](#at-rest),
        [motion](#6-motion), [choices](#7-choices-to-know), [speed](#8-for-speed-the-section-by-hand),
        [numbers](#9-in-numbers-the-first-step-of-a-pendulum); [exercises](../teaching/README.md). Errors in the
        paper: [E1](#e1-an-error-in-the-paper), [E2](#21-its-parts), [E3](#18-strain-energy),
        [E4](#23-elements-held-together).""")
    page.heading("Symbols and units")
    page.words(f"""Bold small letters are columns, bold capitals matrices. A raised T is a transpose, a dot a derivative
        by time, a prime one along the axis. SI units. Each of {symbols} symbols has one meaning, which the program
        checks, too.""")
    page.folded("the list", glossary.write)
