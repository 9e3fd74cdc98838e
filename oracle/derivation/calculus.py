"""Functions, sums, derivatives and integrals as parts of formulas."""

import sympy
from flint import fmpq_mpoly

from ..element import field
from . import algebra
from .algebra import Matrix, each, plus
from .notation import PRODUCT, Node, Symbol, node


class Function(Node):
    """The cosine or the sine of an angle; `meanings` holds the symbols of both."""

    level = PRODUCT

    def __init__(self, name, of, meanings):
        self.name, self.of, self.meanings = name, of, meanings

    def tex(self):
        return f"{self.name} {self.of.tex()}"

    def raised(self, exponent):
        """Text of a power, whose exponent follows the name."""
        return rf"{self.name}^{{{exponent.tex()}}} {self.of.tex()}"

    def value(self, reading):
        return reading.of(self.meanings[self.name])

    def leaves(self):
        return [self.meanings[self.name]]

    def own_changes(self):
        for other in self.meanings:
            if other != self.name:
                yield f"{other} for {self.name}", Function(other, self.of, self.meanings)


class Where(Node):
    """A function of x and y (an expression of sympy) at a place."""

    def __init__(self, function, x, y):
        self.parts = [function, node(x), node(y)]

    def tex(self):
        function, *place = [part.tex() for part in self.parts]
        return rf"{function}({', '.join(place)})"

    def bound(self):
        """Variables replaced by the place."""
        return {field.x, field.y}

    def value(self, reading):
        function, *place = [part.value(reading) for part in self.parts]
        return each(lambda entry: entry.subs(dict(zip((field.x, field.y), place))), function)


class Evaluated(Node):
    """An expression of sympy at a value of one variable, printed with a bar."""

    def __init__(self, part, variable, at):
        self.variable, self.parts = variable, [part, node(at)]

    def with_parts(self, parts):
        return Evaluated(parts[0], self.variable, parts[1])

    def tex(self):
        part, at = [part.tex() for part in self.parts]
        return rf"\left.{part}\right|_{{{self.variable.tex()} = {at}}}"

    def bound(self):
        """Variable replaced by the value."""
        return {self.variable.meaning} | super().bound()

    def value(self, reading):
        part, at = [part.value(reading) for part in self.parts]
        return part.subs(self.variable.meaning, at)


class Determinant(Node):
    """The determinant of a matrix of expressions of sympy."""

    level = PRODUCT

    def __init__(self, part):
        self.parts = [part]

    def tex(self):
        return rf"\det {self.inside(self.parts[0], PRODUCT)}"

    def value(self, reading):
        return sympy.Matrix(self.parts[0].value(reading).rows).det()


class Kronecker(Node):
    """Every entry of a matrix times another matrix."""

    level = PRODUCT

    def __init__(self, entries, block):
        self.parts = [entries, block]

    def tex(self):
        return rf"{self.parts[0].tex()} \otimes {self.parts[1].tex()}"

    def value(self, reading):
        entries, block = (part.value(reading) for part in self.parts)
        return Matrix([[a * b for a in row for b in line] for row in entries.rows for line in block.rows])


class Along(Node):
    """The integral of an expression of sympy over one variable."""

    level = PRODUCT
    spaced = True

    def __init__(self, part, variable, low, high):
        self.variable, self.parts = variable, [part, low, high]

    def with_parts(self, parts):
        return Along(parts[0], self.variable, *parts[1:])

    def tex(self):
        part, low, high = self.parts
        return (rf"\int_{{{low.tex()}}}^{{{high.tex()}}} {self.inside(part, PRODUCT)}"
                rf"\,\mathrm d{self.variable.tex()}")

    def bound(self):
        """Variable of integration."""
        return {self.variable.meaning}

    def value(self, reading):
        part, low, high = [part.value(reading) for part in self.parts]
        return sympy.integrate(sympy.expand(part), (self.variable.meaning, low, high))


class Root(Node):
    """The square root of an expression of sympy."""

    def __init__(self, part):
        self.parts = [part]

    def tex(self):
        return rf"\sqrt{{{self.parts[0].tex()}}}"

    def value(self, reading):
        return sympy.sqrt(self.parts[0].value(reading))


class Integral(Node):
    """An integral over the volume, the length or the section."""

    level = PRODUCT
    spaced = True
    DOMAINS = {
        "V": (r"\int_V", r"\mathrm dV", (True, True)),
        "l": (r"\int_0^l", r"\mathrm dx", (True, False)),
        "A": (r"\int_A", r"\mathrm dA", (False, True)),
    }

    def __init__(self, domain, part):
        self.domain, self.parts = domain, [part]

    def with_parts(self, parts):
        return Integral(self.domain, *parts)

    def tex(self):
        sign, element, _ = self.DOMAINS[self.domain]
        return rf"{sign} {self.inside(self.parts[0], PRODUCT)}\,{element}"

    def value(self, reading):
        value, domain = self.parts[0].value(reading), self.DOMAINS[self.domain][2]
        if reading.numbers:
            return algebra.over_with_numbers(value, *domain, reading.numbers)
        return algebra.over(value, *domain)

    def bound(self):
        """Variables of integration: x and y for every domain."""
        return {"x", "y"}


class Derivative(Node):
    """Derivatives by a column of the ring's variables: the row of a number, the matrix of a column."""

    level = PRODUCT
    spaced = True

    def __init__(self, part, by, names):
        self.by, self.names, self.parts = by, names, [part]

    def with_parts(self, parts):
        return Derivative(*parts, self.by, self.names)

    def tex(self):
        part = self.parts[0]
        if isinstance(part, Symbol):
            return rf"\frac{{\partial {part.tex()}}}{{\partial {self.by}}}"
        return rf"\frac{{\partial}}{{\partial {self.by}}} {self.inside(part, PRODUCT)}"

    def bound(self):
        """Variables of differentiation."""
        return set(self.names)

    def value(self, reading):
        value = self.parts[0].value(reading)
        result = Matrix([[one(entry, name) for name in self.names] for entry in algebra.entries(value)])
        return algebra.scalar(result)


def one(entry, name):
    """Derivative of a polynomial or an expression by one variable."""
    return entry.derivative(name) if isinstance(entry, fmpq_mpoly) else sympy.diff(entry, name)


class Indexed(Node):
    """A formula that depends on an index: `term(n)` for a number, `term("n")` to print."""

    level = PRODUCT
    spaced = True

    def __init__(self, term, index, last=2, change=None):
        self.term, self.index, self.last, self.change = term, index, last, change

    def at(self, index):
        """Formula of an index, with the mistake if there is one."""
        term = self.term(index)
        return term if self.change is None else list(term.changes())[self.change][1]

    def values(self, reading):
        """Values for all indices."""
        return [self.at(k).value(reading) for k in range(1, self.last + 1)]

    def leaves(self):
        return self.at(1).leaves() + self.at(2).leaves()

    def bound(self):
        return self.at(1).bound()

    def own_changes(self):
        for k, (what, _) in enumerate(self.term(1).changes()):
            yield what, type(self)(self.term, self.index, self.last, k)


class Total(Indexed):
    """A sum over an index."""

    def tex(self):
        return rf"\sum_{{{self.index}=1}}^{{{self.last}}} {self.inside(self.at(self.index), PRODUCT)}"

    def value(self, reading):
        first, *others = self.values(reading)
        for other in others:
            first = plus(first, other)
        return first


class Each(Indexed):
    """A formula that holds for each value of an index; its value is the column of them all."""

    spaced = False

    def tex(self):
        return self.at(self.index).tex()

    def value(self, reading):
        return algebra.column(self.values(reading))
