"""Values of formulas: polynomials over the rational numbers, expressions of sympy, and matrices of either.

The ring has a variable for every symbol of an element, for l and for 1/l, and for the cosine and the sine of the
inclination. A polynomial is zero if it vanishes with l (1/l) = 1 and cos^2 + sin^2 = 1.

The polynomials are those of python-flint because sympy's are too slow: the product in one entry of (21) takes 0.1 ms here,
32 ms with sympy's sparse polynomials and 4.4 s with `sympy.expand`, and a matrix has 196 entries.
"""

import random

import sympy
from flint import fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from ..fixtures.fixture import from_sympy

DOF = 14
# g1 and g2 are the components of any plane vector; e1 ... e14 are nodal coordinates or their rates, as no formula has both.
NODAL = [f"e{k}" for k in range(1, DOF + 1)]
NAMES = ["x", "y", "l", "per_l", "c", "s", "h", "w", "rho", "lam", "mu", "heat", "g1", "g2", *NODAL]
RING = fmpq_mpoly_ctx.get(NAMES)
GEN = dict(zip(NAMES, RING.gens()))
X, Y, L, PER_L, S, H, W = (NAMES.index(name) for name in ("x", "y", "l", "per_l", "s", "h", "w"))


class Matrix:
    """Rows of numbers, polynomials or expressions."""

    def __init__(self, rows):
        self.rows = [list(row) for row in rows]
        self.shape = (len(self.rows), len(self.rows[0]))
        assert all(len(row) == self.shape[1] for row in self.rows)

    def __getitem__(self, place):
        return self.rows[place[0]][place[1]]

    def each(self, change):
        """The matrix with a function applied to every entry."""
        return Matrix([[change(entry) for entry in row] for row in self.rows])

    def transpose(self):
        """Rows and columns exchanged."""
        return Matrix(zip(*self.rows))

    def __add__(self, other):
        if self.shape != other.shape:
            raise ValueError(f"shapes {self.shape} and {other.shape} do not add")
        return Matrix([[a + b for a, b in zip(*rows)] for rows in zip(self.rows, other.rows)])

    def __neg__(self):
        return self.each(lambda entry: -entry)

    def __sub__(self, other):
        return self + -other

    def __matmul__(self, other):
        if self.shape[1] != other.shape[0]:
            raise ValueError(f"shapes {self.shape} and {other.shape} do not multiply")
        columns = list(zip(*other.rows))
        return Matrix([[total(a * b for a, b in zip(row, column)) for column in columns] for row in self.rows])

    def inverse(self):
        """Inverse of a 2 x 2 matrix of the ring whose determinant in normal form is a number."""
        (a, b), (c, d) = self.rows
        determinant = number(normal(RING.constant(0) + a * d - b * c))
        return Matrix([[d, -b], [-c, a]]).each(lambda entry: entry * (1 / determinant))


def total(terms):
    """Sum of terms that need not be numbers."""
    terms = list(terms)
    result = terms[0]
    for term in terms[1:]:
        result = result + term
    return result


def column(entries):
    """A matrix of one column."""
    return Matrix([[entry] for entry in entries])


def times(a, b):
    """Product of two numbers, two matrices, or one of each; 1 x 1 matrices are numbers."""
    a, b = scalar(a), scalar(b)
    if isinstance(a, Matrix) and isinstance(b, Matrix):
        return scalar(a @ b)
    if isinstance(b, Matrix):
        return b.each(lambda entry: a * entry)
    return a.each(lambda entry: entry * b) if isinstance(a, Matrix) else a * b


def plus(a, b):
    """Sum of two numbers or two matrices."""
    a, b = scalar(a), scalar(b)
    if isinstance(a, Matrix) != isinstance(b, Matrix):
        raise ValueError("a number and a matrix do not add")
    return a + b


def scalar(value):
    """The entry of a 1 x 1 matrix; any other value unchanged."""
    return value[0, 0] if isinstance(value, Matrix) and value.shape == (1, 1) else value


def each(change, value):
    """A function applied to a number or to every entry of a matrix."""
    return value.each(change) if isinstance(value, Matrix) else change(value)


def entries(value):
    """All numbers of a matrix, or the number itself."""
    return [entry for row in value.rows for entry in row] if isinstance(value, Matrix) else [value]


def number(polynomial):
    """Value of a constant polynomial."""
    assert polynomial.is_constant()
    return polynomial(*[0] * len(NAMES))


def normal(polynomial):
    """Normal form of a polynomial: l (1/l) = 1 and sin^2 = 1 - cos^2."""
    plain, result = {}, RING.constant(0)
    for exponents, coefficient in polynomial.to_dict().items():
        powers = list(exponents)
        shared = min(powers[L], powers[PER_L])
        powers[L] -= shared
        powers[PER_L] -= shared
        squares, powers[S] = divmod(powers[S], 2)
        terms = plain.setdefault(squares, {})
        terms[tuple(powers)] = terms.get(tuple(powers), 0) + coefficient
    for squares, terms in plain.items():
        result += RING.from_dict(terms) * (1 - GEN["c"] ** 2) ** squares
    return result


def some_values(seed):
    """Rational values for all symbols but x and y, in which l (1/l) = 1 and cos^2 + sin^2 = 1."""
    choice = random.Random(seed)
    values = {name: fmpq(choice.randint(2, 40), choice.randint(2, 40)) for name in NAMES[2:]}
    a, b = choice.randint(2, 9), choice.randint(10, 19)
    size = a * a + b * b
    return values | {"per_l": 1 / values["l"], "c": fmpq(2 * a * b, size), "s": fmpq(b * b - a * a, size)}


SOMEWHERE, SOMEWHERE_ELSE = ({"x": fmpq(3, 7), "y": fmpq(5, 11)} | some_values(seed) for seed in (1, 2))


def is_zero(value):
    """Whether a number or every entry of a matrix is zero for all values of its symbols."""
    if isinstance(value, Matrix):
        return all(is_zero(entry) for row in value.rows for entry in row)
    if isinstance(value, fmpq_mpoly) and value.context() == RING:
        # One point is tried first: a polynomial that is nonzero there needs no normal form.
        return value(*[SOMEWHERE[name] for name in NAMES]) == 0 and normal(value) == 0
    return sympy.simplify(sympy.sympify(value)) == 0 if isinstance(value, sympy.Basic) else value == 0


def lift(expression, symbols):
    """A polynomial of sympy in `symbols`, which are l and others with the ring's names, as one of the ring."""
    symbols = {symbol: str(symbol) for symbol in symbols}
    per_l, l = sympy.Symbol("per_l"), sympy.Symbol("l")
    flat = sympy.expand(expression).replace(
        lambda part: part.is_Pow and part.base == l and part.exp.is_negative, lambda part: per_l ** -part.exp)
    order = [*symbols, per_l]
    names = [*symbols.values(), "per_l"]
    result = RING.constant(0)
    for exponents, coefficient in sympy.Poly(flat, *order).terms():
        term = RING.constant(from_sympy(coefficient))
        for name, power in zip(names, exponents):
            term *= GEN[name] ** power
        result += term
    return result


def replace(polynomial, **by):
    """A polynomial with some of its variables replaced by polynomials."""
    return polynomial.compose(*[by.get(name, GEN[name]) for name in NAMES])


# Ring of the polynomials in x and y alone, with numbers for all other variables.
SMALL = fmpq_mpoly_ctx.get(["x", "y"])


def over_with_numbers(value, length, section, numbers):
    """The integral of `over` where all variables but x and y are numbers."""
    def one(polynomial):
        result = fmpq(0)
        for (p, q), coefficient in (SMALL.constant(0) + polynomial).to_dict().items():
            if length:
                coefficient = coefficient * numbers["l"] ** (p + 1) / (p + 1)
            if section:
                coefficient = 0 if q % 2 else coefficient * 2 * (numbers["h"] / 2) ** (q + 1) / (q + 1) * numbers["w"]
            result += coefficient
        return result

    return each(one, value)


def over(value, length, section):
    """Integral of every entry, term by term, over 0 <= x <= l (`length`), over -h/2 <= y <= h/2 times w (`section`), or both."""

    def one(polynomial):
        terms = {}
        for exponents, coefficient in (RING.constant(0) + polynomial).to_dict().items():
            powers = list(exponents)
            if length:
                powers[L] += powers[X] + 1
                coefficient, powers[X] = coefficient / (powers[X] + 1), 0
            if section:
                if powers[Y] % 2:
                    continue
                powers[H] += powers[Y] + 1
                powers[W] += 1
                coefficient, powers[Y] = coefficient / ((powers[Y] + 1) * 2 ** powers[Y]), 0
            shared = min(powers[L], powers[PER_L])
            powers[L] -= shared
            powers[PER_L] -= shared
            powers = tuple(powers)
            terms[powers] = terms.get(powers, 0) + coefficient
        return RING.from_dict(terms)

    return each(one, value)


def over_volume(value):
    """Integral over the volume of the element."""
    return over(value, True, True)


def hessian(polynomial, names):
    """Matrix of second derivatives."""
    first = [polynomial.derivative(name) for name in names]
    return Matrix([[row.derivative(name) for name in names] for row in first])
