"""The page: words, formulas that are asserted as they are written, and links into the code."""

import sympy
from flint import fmpq, fmpq_mpoly

from . import algebra
from .algebra import Matrix, is_zero
from .notation import Reading, Symbol, compute

# What the front matter does not say of every formula: only some are compared in numbers.
KINDS = {"ring": "", "sympy": "", "state": " In numbers."}


class Formula:
    """A chain of equalities: parts that must be equal, in their order on the page."""

    def __init__(self, parts):
        self.parts = list(parts)
        first, *others = compute(self.parts, Reading())
        for part, value in zip(self.parts[1:], others):
            assert same(first, value), f"not equal:\n  {self.parts[0].tex()}\n  {part.tex()}"

    @property
    def kind(self):
        """Type of the values: polynomials, expressions, or only numbers."""
        entries = [entry for part in self.parts for leaf in part.leaves() for entry in entries_of(leaf)]
        if any(isinstance(entry, fmpq_mpoly) for entry in entries):
            return "ring"
        return "state" if any(isinstance(entry, fmpq) for entry in entries) else "sympy"

    def lines(self):
        """Lines of the text, broken before each equality sign except the first."""
        first, second, *others = [part.tex() for part in self.parts]
        return [f"{first} &= {second}", *(f"&= {other}" for other in others)]

    def changes(self):
        """Pairs (description, parts) for each mistake in a part that is more than a name."""
        for k, part in enumerate(self.parts):
            if not isinstance(part, Symbol):
                for what, changed in part.changes():
                    yield what, [*self.parts[:k], changed, *self.parts[k + 1:]]

    def unnoticed(self):
        """Mistakes that leave the assertion true, and the number of all mistakes."""
        bound = set().union(*(part.bound() for part in self.parts))
        numbers = {name: value for name, value in numbers_for(self.parts).items() if name not in bound}
        quick, found, count = Reading(numbers), [], 0
        for what, parts in self.changes():
            count += 1
            # Numbers are quick and find most mistakes; equality in numbers must be confirmed with symbols.
            if holds(parts, quick) and holds(parts, Reading()):
                found.append(what)
        return found, count


def entries_of(leaf):
    """Meaning of a symbol as a list of numbers."""
    return algebra.entries(leaf.meaning) if isinstance(leaf, Symbol) else []


def same(a, b):
    """Whether two values are equal."""
    if isinstance(a, Matrix) != isinstance(b, Matrix) or isinstance(a, Matrix) and a.shape != b.shape:
        return False
    return is_zero(a - b)


def unassuming(leaf):
    """Meaning of a symbol without what sympy is told of its variables, such as that a length is positive."""
    def one(entry):
        if not isinstance(entry, sympy.Basic):
            return entry
        return entry.xreplace({symbol: sympy.Symbol(symbol.name) for symbol in entry.free_symbols})

    return algebra.each(one, leaf.meaning)


def holds(parts, reading):
    """Whether formulas that may be wrong are equal."""
    try:
        first, *others = compute(parts, reading)
    except (ValueError, ZeroDivisionError, AssertionError):
        return False  # shapes that do not match, a division by zero, a singular matrix
    return all(same(first, value) for value in others)


def numbers_for(parts):
    """Rational numbers for the ring's variables, and for those of sympy except angles."""
    values = [entry for part in parts for leaf in part.leaves() for entry in entries_of(leaf)]
    symbols = set().union(*(value.free_symbols for value in values if isinstance(value, sympy.Basic)))
    chosen = {symbol: sympy.Rational(7 + 2 * k, 11 + k) for k, symbol in enumerate(sorted(symbols, key=str))
              if symbol.name != "theta"}
    return algebra.SOMEWHERE_ELSE | chosen


class Page:
    """The text of the page, from top to bottom, with its formulas."""

    def __init__(self):
        self.blocks, self.groups, self.printed, self.meanings = [], [], [], {}

    def heading(self, title, level=2):
        """A heading without an equation."""
        self.blocks.append(f"{'#' * level} {title}")

    def section(self, number, title, rust=()):
        """The section of an equation, with the functions that state it in Rust."""
        self.heading(f"({number}) {title}" if number else title, 3)
        if rust:
            self.rust(*rust)

    def rust(self, *items):
        """Links to functions and types of src/, given as module.file::item."""
        links = []
        for item in items:
            file, name = item.split("::")
            links.append(f"[`{file.split('.')[-1]}::{name}`](../src/{file.replace('.', '/')}.rs)")
        self.blocks.append("In Rust: " + ", ".join(links) + ".")

    def words(self, text, **named):
        """A paragraph. It has no typed formula: {name} is replaced by one of `named`."""
        assert "$" not in text and "\\" not in text, f"typed formula: {text}"
        self.printed += [part.tex() for part in named.values()]
        self.blocks.append(" ".join(text.format_map(named).split()))

    def figure(self, name, words):
        """A picture of `figures`, and what it shows."""
        self.blocks.append(f"![{name}](figures/{name}.svg)\n\n*{' '.join(words.split())}.*")

    def exercise(self, task, sheet, **named):
        """A task for pen and paper, with the sheet that has it and more."""
        self.words(f"**Exercise.** {task} More, with solutions: [sheet {sheet[0]}](../teaching/{sheet}.md).", **named)

    def table(self, head, rows):
        """A table of words and symbols."""
        lines = [head, ["---"] * len(head), *rows]
        self.blocks.append("\n".join("| " + " | ".join(line) + " |" for line in lines))

    def folded(self, summary, write):
        """Blocks that `write` adds, folded away."""
        self.blocks.append(f"<details><summary>{summary}</summary>")
        write(self)
        self.blocks.append("</details>")

    def formula(self, *parts, number=None, how, blind=()):
        """One displayed chain of equalities."""
        self.formulas_of([parts], number=number, how=how, blind=blind)

    def formulas_of(self, chains, *, number=None, how, blind=()):
        """Several chains under one number. `blind` lists the equivalent mistakes, which change a zero or nothing."""
        formulas = [Formula(chain) for chain in chains]
        self.groups.append((formulas, set(blind)))
        for formula in formulas:
            self.remember(formula)
        lines = [line for formula in formulas for line in formula.lines()]
        body = lines[0].replace("&= ", "= ") if len(lines) == 1 else (
            "\\begin{aligned}\n" + " \\\\\n".join(lines) + "\n\\end{aligned}")
        tag = f" \\tag{{{number}}}" if number else ""
        kinds = "".join(dict.fromkeys(KINDS[formula.kind] for formula in formulas))
        self.blocks.append(f"```math\n{body}{tag}\n```")
        self.blocks.append(f"<details><summary>checked</summary>\n\n{' '.join(how.split())}{kinds}\n\n</details>")

    def remember(self, formula):
        """Keeps what is printed, and asserts that a symbol of letters stands for one thing in polynomials and one in expressions."""
        self.printed += [part.tex() for part in formula.parts]
        for leaf in [leaf for part in formula.parts for leaf in part.leaves() if isinstance(leaf, Symbol)]:
            if formula.kind != "state":
                known = self.meanings.setdefault((leaf.text, formula.kind), leaf)
                assert known.meaning is leaf.meaning or same(unassuming(known), unassuming(leaf)), f"two meanings: {leaf.text}"

    def text(self):
        """The page as Markdown."""
        return "\n\n".join(self.blocks) + "\n"

    def noticed(self):
        """Numbers of formulas, of mistakes tried and of equivalent mistakes; all others must be noticed."""
        count = tried = none = 0
        for formulas, blind in self.groups:
            found = []
            for formula in formulas:
                unnoticed, number = formula.unnoticed()
                found += unnoticed
                tried += number
            assert set(found) == blind, f"{formulas[0].parts[0].tex()}: unnoticed {set(found)}, declared {blind}"
            count, none = count + len(formulas), none + len(found)
        return count, tried, none
