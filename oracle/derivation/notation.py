"""Formulas as trees: `tex` prints a tree, `value` computes it, `changes` makes small mistakes in it.

Printing and computing walk the same tree, so that a change of the printed formula changes its value.

Why the trees are not sympy's (1.14, tried on all 129 formulas). Sympy's trees carry the mutation check: with unevaluated
constructors and a walker over the ring, all 1,451 mistakes but 23 equivalent ones were noticed, in the time of these trees. But
formulas could no longer be written with operators. `J.T * J - I` becomes -I + J^T J; under `evaluate(False)` matrix expressions
lose signs, so that 3 A - 4 B + C is 3 A + 4 B + C; and e^T S e - 1 is a TypeError, as a 1 x 1 matrix is no number. Of the 164
printed sides 75 came out unchanged with operators and 108 with constructors; 11 could not be built. Sympy would replace 188 of
the 602 lines of this file and `calculus`. The trial's builder, walker and mistakes took 105 lines, without operators and without
the printing rules for 34 sides: no code is saved.
"""

from fractions import Fraction

import sympy
from flint import fmpq, fmpq_mpoly

from . import algebra
from .algebra import Matrix, each, plus, times

SUM, PRODUCT, POWER, ATOM = range(4)


class Reading:
    """Values of symbols for computing a tree: their meanings, or rational numbers for variables."""

    def __init__(self, numbers=None):
        self.numbers, self.ring, self.known = numbers, False, {}

    def of(self, leaf):
        """Value of a symbol."""
        if leaf not in self.known:
            self.known[leaf] = each(self.substituted, leaf.meaning) if self.numbers else leaf.meaning
        return self.known[leaf]

    def substituted(self, entry):
        """An entry with rational numbers for its variables."""
        if isinstance(entry, fmpq_mpoly):
            known = {name: value for name, value in self.numbers.items() if name in algebra.NAMES}
            if len(known) == len(algebra.NAMES):
                return entry(*[known[name] for name in algebra.NAMES])
            rest = entry.subs(known)
            return rest.project_to_context(algebra.SMALL) if len(known) == len(algebra.NAMES) - 2 else rest
        if isinstance(entry, sympy.Basic):
            return entry.subs({symbol: self.numbers[symbol] for symbol in entry.free_symbols if symbol in self.numbers})
        return entry

    def rational(self, value):
        """A rational number of the type that the formula's symbols need."""
        number = fmpq if self.ring else sympy.Rational
        return number(value.numerator, value.denominator)


def compute(formulas, reading):
    """Values of formulas that are compared."""
    reading.ring = any(in_ring(leaf) for formula in formulas for leaf in formula.leaves())
    return [formula.value(reading) for formula in formulas]


def in_ring(leaf):
    """Whether a symbol stands for polynomials or for numbers of flint."""
    meaning = getattr(leaf, "meaning", None)
    return any(isinstance(entry, (fmpq, fmpq_mpoly)) for entry in algebra.entries(meaning))


class Node:
    """A part of a formula."""

    level = ATOM
    # Whether a thin space separates it from the factor before it.
    spaced = False
    parts = ()

    def __add__(self, other):
        return Add(self, node(other))

    def __radd__(self, other):
        return Add(node(other), self)

    def __sub__(self, other):
        return Add(self, Negative(node(other)))

    def __rsub__(self, other):
        return Add(node(other), Negative(self))

    def __neg__(self):
        return Negative(self)

    def __mul__(self, other):
        return Product(self, node(other))

    def __rmul__(self, other):
        return Product(node(other), self)

    def __truediv__(self, other):
        return Quotient(self, node(other))

    def __pow__(self, power):
        return Power(self, node(power))

    def __format__(self, _):
        return f"$`{self.tex()}`$"

    @property
    def T(self):
        """The transpose."""
        return Transposed(self)

    def inside(self, part, least):
        """Text of a part, in brackets where it binds less tightly than `least`."""
        text = part.tex()
        return text if part.level >= least else rf"\left({text}\right)"

    def leaves(self):
        """All symbols and numbers."""
        return [leaf for part in self.parts for leaf in part.leaves()]

    def bound(self):
        """Variables that must remain variables while it is computed."""
        return set().union(*(part.bound() for part in self.parts))

    def with_parts(self, parts):
        """A node of this type with other parts."""
        return type(self)(*parts)

    def own_changes(self):
        """Mistakes in this node itself."""
        return []

    def changes(self):
        """Pairs (description, changed formula) for every mistake in this node and its parts."""
        yield from self.own_changes()
        for k, part in enumerate(self.parts):
            for what, changed in part.changes():
                yield what, self.with_parts([*self.parts[:k], changed, *self.parts[k + 1:]])


def node(value):
    """A number as a formula."""
    return value if isinstance(value, Node) else Number(Fraction(value))


class Number(Node):
    """A whole number or a fraction."""

    def __init__(self, number):
        self.number = number
        self.level = PRODUCT if number.denominator > 1 else ATOM if number >= 0 else SUM

    def tex(self):
        p, q = self.number.numerator, self.number.denominator
        return str(p) if q == 1 else (r"-" if p < 0 else "") + rf"\tfrac{{{abs(p)}}}{{{q}}}"

    def value(self, reading):
        return reading.rational(self.number)

    def leaves(self):
        return [self]

    def own_changes(self):
        yield f"{self.number} + 1", Number(self.number + 1)


class Decimal(Number):
    """A number written as a decimal, with a power of ten where it is small or large: `Decimal("-6.125e-10")`."""

    def __init__(self, text):
        super().__init__(Fraction(text))
        self.text = text
        self.level = PRODUCT if self.number >= 0 else SUM

    def tex(self):
        mantissa, _, power = self.text.partition("e")
        exponent = rf"10^{{{int(power)}}}" if power else ""
        return exponent if mantissa == "1" and exponent else rf"{mantissa} \cdot {exponent}" if exponent else mantissa


class Symbol(Node):
    """A name with its meaning: a number, a polynomial, an expression or a matrix of these."""

    def __init__(self, text, meaning, level=None):
        self.text, self.meaning = text, meaning
        # A name with a superscript needs brackets before another one.
        self.level = (POWER if "^" in text else ATOM) if level is None else level

    def tex(self):
        return self.text

    def value(self, reading):
        return reading.of(self)

    def leaves(self):
        return [self]

    def own_changes(self):
        yield f"2 {self.text}", Product(Number(Fraction(2)), self)


class Add(Node):
    """A sum; negative terms are printed with a minus."""

    level = SUM

    def __init__(self, *terms):
        self.parts = [part for term in terms for part in (term.parts if type(term) is Add else [term])]

    def tex(self):
        text = ""
        for k, part in enumerate(self.parts):
            minus = isinstance(part, Negative)
            body = part.inside(part.parts[0], PRODUCT) if minus else part.tex()
            text += (" - " if minus else " + " if k else "") + body
        return text.strip()

    def value(self, reading):
        result = self.parts[0].value(reading)
        for part in self.parts[1:]:
            result = plus(result, part.value(reading))
        return result

    def own_changes(self):
        for k, part in enumerate(self.parts):
            minus = part.parts[0] if isinstance(part, Negative) else Negative(part)
            yield f"sign of {part.tex()}", Add(*self.parts[:k], minus, *self.parts[k + 1:])


class Negative(Node):
    """A negative term."""

    level = SUM

    def __init__(self, part):
        self.parts = [part]

    def tex(self):
        return "-" + self.inside(self.parts[0], PRODUCT)

    def value(self, reading):
        return times(reading.rational(Fraction(-1)), self.parts[0].value(reading))


class Product(Node):
    """A product of numbers or matrices in the order given."""

    level = PRODUCT

    def __init__(self, *factors):
        self.parts = [part for factor in factors for part in (factor.parts if type(factor) is Product else [factor])]

    def tex(self):
        texts = [self.inside(part, PRODUCT) for part in self.parts]
        text = texts[0]
        for before, part, added in zip(self.parts, self.parts[1:], texts[1:]):
            numbers = isinstance(part, Number) and isinstance(before, Number)
            text += (r" \cdot " if numbers else r"\," if part.spaced else " ") + added
        return text

    def value(self, reading):
        result = self.parts[0].value(reading)
        for part in self.parts[1:]:
            result = times(result, part.value(reading))
        return result


class Grouped(Node):
    """A product in brackets: a number between matrices."""

    def __init__(self, part):
        self.parts = [part]

    def tex(self):
        return rf"\left({self.parts[0].tex()}\right)"

    def value(self, reading):
        return self.parts[0].value(reading)


class Quotient(Node):
    """A fraction whose denominator is a number, a symbol l of the ring, or an expression of sympy."""

    level = PRODUCT

    def __init__(self, above, below):
        self.parts = [above, below]

    def tex(self):
        return rf"\frac{{{self.parts[0].tex()}}}{{{self.parts[1].tex()}}}"

    def value(self, reading):
        above, below = (part.value(reading) for part in self.parts)
        if isinstance(below, fmpq_mpoly):
            if below == algebra.GEN["l"]:
                return times(above, algebra.GEN["per_l"])
            below = algebra.number(below)
        return times(above, 1 / below)


class Power(Node):
    """A power. The exponent of a function follows its name."""

    level = POWER

    def __init__(self, base, exponent):
        self.parts = [base, exponent]

    def tex(self):
        base, exponent = self.parts
        if hasattr(base, "raised"):
            return base.raised(exponent)
        return rf"{self.inside(base, ATOM)}^{{{exponent.tex()}}}"

    def value(self, reading):
        base, exponent = self.parts[0].value(reading), self.parts[1].value(reading)
        return base ** int(exponent)


class Transposed(Node):
    """The transpose of a matrix."""

    level = POWER

    def __init__(self, part):
        self.parts = [part]

    def tex(self):
        return rf"{self.inside(self.parts[0], ATOM)}^{{\mathsf T}}"

    def value(self, reading):
        value = self.parts[0].value(reading)
        return value.transpose() if isinstance(value, Matrix) else value

    def own_changes(self):
        yield f"no transpose of {self.parts[0].tex()}", self.parts[0]


class Inverse(Node):
    """The inverse of a 2 x 2 matrix."""

    level = POWER

    def __init__(self, part):
        self.parts = [part]

    def tex(self):
        return rf"{self.inside(self.parts[0], ATOM)}^{{-1}}"

    def value(self, reading):
        return self.parts[0].value(reading).inverse()

    def own_changes(self):
        yield f"no inverse of {self.parts[0].tex()}", self.parts[0]


class Table(Node):
    """A matrix with its entries, which are numbers or blocks."""

    def __init__(self, *rows):
        self.width = len(rows[0])
        self.parts = [node(entry) for row in rows for entry in row]

    def with_parts(self, parts):
        return Table(*[parts[k:k + self.width] for k in range(0, len(parts), self.width)])

    def tex(self):
        texts = [part.tex() for part in self.parts]
        rows = [" & ".join(texts[k:k + self.width]) for k in range(0, len(texts), self.width)]
        return r"\begin{bmatrix}" + r" \\ ".join(rows) + r"\end{bmatrix}"

    def value(self, reading):
        rows = []
        for k in range(0, len(self.parts), self.width):
            blocks = [part.value(reading) for part in self.parts[k:k + self.width]]
            blocks = [block.rows if isinstance(block, Matrix) else [[block]] for block in blocks]
            if len({len(block) for block in blocks}) != 1:
                raise ValueError("blocks of one row must have equal heights")
            rows += [[entry for block in blocks for entry in block[i]] for i in range(len(blocks[0]))]
        return Matrix(rows)


class Named(Node):
    """A formula with a name under a brace."""

    level = PRODUCT

    def __init__(self, name, part):
        self.name, self.parts = name, [part]

    def with_parts(self, parts):
        return Named(self.name, *parts)

    def tex(self):
        return rf"\underbrace{{{self.parts[0].tex()}}}_{{\text{{{self.name}}}}}"

    def value(self, reading):
        return self.parts[0].value(reading)
