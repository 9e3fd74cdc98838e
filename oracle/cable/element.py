"""One cable element in exact numbers: cubic Hermite axis, axial strain, material curvature, Gauss sums.

The axis r(x) is the cubic through positions and slopes at both ends (Berzeri and Shabana 2000). The energy is that of
the axial strain and of the material curvature (Gerstmayr and Irschik 2008). Only the root in |r_x| and the Gauss points
are irrational. In a straight, evenly stretched element the root is rational and the Gauss sums are integrals of
polynomials, so that all values are exact.
"""

from functools import cache, cached_property
from math import prod

import sympy
from flint import arb, fmpq, fmpq_mat, fmpq_poly

from ..fixtures.fixture import from_sympy
from .ball import at

DOF = 8
PLANE = range(2)

# Numbers of Gauss points of the two energies; they belong to the definition of the element.
AXIAL_POINTS, BENDING_POINTS = 5, 3

# The strains as functions of the slope g = r_x, of c = r_xx and of the thermal strain a.
G, C = sympy.symbols("g_1:3"), sympy.symbols("c_1:3")
HEAT = sympy.Symbol("a")
METRIC = G[0] ** 2 + G[1] ** 2
EPSILON = sympy.sqrt(METRIC) - 1 - HEAT
KAPPA = (G[0] * C[1] - G[1] * C[0]) / METRIC


@cache
def derivatives(strain):
    """Value, gradient and second derivative of strain^2/2 with respect to (g, c)."""
    density, variables = strain**2 / 2, G + C
    slope = [density.diff(v) for v in variables]
    return density, slope, [[entry.diff(v) for v in variables] for entry in slope]


def evaluate(expression, values, root):
    """Value of an expression of sums, products and half-integer powers; `root` computes square roots."""
    if expression.is_Rational:
        return from_sympy(expression)
    if expression.is_Symbol:
        return values[expression]
    if expression.is_Pow:
        base, halves = evaluate(expression.base, values, root), int(2 * expression.exp)
        assert halves == 2 * expression.exp
        return power(base, halves // 2) if halves % 2 == 0 else power(root(base), halves)
    terms = [evaluate(argument, values, root) for argument in expression.args]
    assert expression.is_Add or expression.is_Mul
    return sum(terms) if expression.is_Add else prod(terms)


def power(base, exponent):
    """An integer power by multiplication; `**` has no value for a ball that contains zero."""
    product = prod([base] * abs(exponent))
    return product if exponent >= 0 else 1 / product


def evaluate_each(expressions, *context):
    """Values of nested lists and tuples of expressions."""
    if isinstance(expressions, (list, tuple)):
        return [evaluate_each(expression, *context) for expression in expressions]
    return evaluate(expressions, *context)


def rational_root(value):
    """The square root of a rational number, or None if it is irrational."""
    parts = [int(part) for part in (value.p, value.q)]
    roots = [int(sympy.integer_nthroot(part, 2)[0]) for part in parts]
    return fmpq(*roots) if [root**2 for root in roots] == parts else None


@cache
def shape_functions(length):
    """S_1 ... S_4: one component of a_0 + a_1 x + a_2 x^2 + a_3 x^3 by its value and slope at 0 and at l."""
    powers = [fmpq_poly([0] * n + [1]) for n in range(4)]
    conditions = fmpq_mat([
        [function(place) for function in functions]
        for place in (fmpq(0), length) for functions in (powers, [power.derivative() for power in powers])
    ])
    # Column k holds the coefficients of the cubic whose k-th nodal value is one and whose others are zero.
    inverse = conditions.inv()
    return [fmpq_poly([inverse[n, k] for n in range(4)]) for k in range(4)]


@cache
def gauss(points, length):
    """Weights and places of the Gauss rule over 0 <= x <= l, as balls."""
    half = length / 2
    rule = [arb.legendre_p_root(points, k, weight=True) for k in range(points)]
    return [(weight * half, (1 + root) * half) for root, weight in rule]


class Element:
    """Quantities of one cable element in one `State`."""

    def __init__(self, state):
        self.state = state
        self.shapes = shape_functions(state.l)
        self.shapes_x = [S.derivative() for S in self.shapes]
        self.shapes_xx = [S.derivative() for S in self.shapes_x]
        self.heat = state.alpha * state.dT if state.model != "none" else fmpq(0)
        self.area = state.h * state.w
        self.EA = state.E * self.area
        self.EI = state.E * state.w * state.h**3 / 12

    @staticmethod
    def field(shapes, e):
        """Components of the sum of shape functions, or of their derivatives, times nodal vectors."""
        return [sum((S * q for S, q in zip(shapes, e[i::2])), fmpq_poly()) for i in PLANE]

    @cached_property
    def slope(self):
        """r_x as polynomials in x."""
        return self.field(self.shapes_x, self.state.e)

    @cached_property
    def bend(self):
        """r_xx as polynomials in x."""
        return self.field(self.shapes_xx, self.state.e)

    @cached_property
    def is_even(self):
        """Whether r_x is constant along the axis and of rational length."""
        return not any(self.bend) and rational_root(sum(g(0) ** 2 for g in self.slope)) is not None

    def strain(self, expression, place):
        """`EPSILON`, `KAPPA`, or expressions of their derivatives, at a place of the axis."""
        vectors = [at(component, place) for component in self.slope + self.bend]
        values = dict(zip(G + C, vectors)) | {HEAT: self.heat}
        root = rational_root if self.is_even else lambda square: arb(square).sqrt()
        return evaluate_each(expression, values, root)

    # Inertia and weight.

    def integral(self, polynomial):
        """The integral over 0 <= x <= l."""
        return polynomial.integral()(self.state.l)

    @cached_property
    def mass(self):
        """M, the integral of rho A S^T S."""
        density = self.state.rho * self.area
        products = [[density * self.integral(a * b) for b in self.shapes] for a in self.shapes]
        return fmpq_mat([[products[i // 2][j // 2] * int(i % 2 == j % 2) for j in range(DOF)]
                         for i in range(DOF)])

    @cached_property
    def kinetic_energy(self):
        """T, the integral of rho A |r'|^2 / 2 for the velocity r'."""
        velocity = self.field(self.shapes, self.state.edot)
        return self.state.rho * self.area * self.integral(sum(v * v for v in velocity)) / 2

    @cached_property
    def gravity_force(self):
        """Q_w, the integral of rho A S^T g."""
        weight = [self.state.rho * self.area * g for g in self.state.gravity]
        return [weight[i] * self.integral(S) for S in self.shapes for i in PLANE]

    # Energy and its derivatives.

    @cached_property
    def parts(self):
        """Stiffness, Gauss rule, and the derivatives of `EPSILON`^2/2 and `KAPPA`^2/2 at its points."""
        parts = []
        for stiffness, strain, points in (
            (self.EA, EPSILON, AXIAL_POINTS), (self.EI, KAPPA, BENDING_POINTS),
        ):
            # In an even element the derivatives do not depend on x, so that one place suffices.
            rule = [(None, fmpq(0))] if self.is_even else gauss(points, self.state.l)
            parts.append((stiffness, [(w, x, self.strain(derivatives(strain), x)) for w, x in rule]))
        return parts

    def gauss_sum(self, pick, polynomial):
        """Sum over both energies and their Gauss points of weight, picked derivative and polynomial.

        In an even element the polynomial has degree four at most (EA), or two (EI). It is integrated
        instead, as the rules are exact for it.
        """
        def weighted(weight, place):
            return self.integral(polynomial) if weight is None else weight * at(polynomial, place)

        return sum(stiffness * pick(found) * weighted(weight, place)
                   for stiffness, points in self.parts for weight, place, found in points)

    @cached_property
    def rates(self):
        """Derivatives of (g, c) with respect to e: rows of (index of the variable, polynomial)."""
        return [[(i, self.shapes_x[k]), (2 + i, self.shapes_xx[k])] for k in range(4) for i in PLANE]

    @cached_property
    def energy(self):
        """U: the five-point sum of EA epsilon^2/2 and the three-point sum of EI kappa^2/2."""
        return self.gauss_sum(lambda found: found[0], fmpq_poly([1]))

    @cached_property
    def force(self):
        """Q_e = dU/de."""
        return [sum(self.gauss_sum(lambda found: found[1][v], S) for v, S in rate) for rate in self.rates]

    @cached_property
    def tangent(self):
        """d2U/de2; g and c are linear in e."""
        return [[sum(self.gauss_sum(lambda found: found[2][v][u], S * R) for v, S in row for u, R in column)
                 for column in self.rates] for row in self.rates]

    @cached_property
    def acceleration(self):
        """Nodal accelerations that solve M e'' = Q_w - Q_e."""
        load = [w - Q for w, Q in zip(self.gravity_force, self.force)]
        return [sum(m * f for m, f in zip(row, load)) for row in self.mass.inv().tolist()]
