"""The element's position field, from the polynomial (A.1) and the nodal conditions (A.2).

All results are symbolic in the length l and the element coordinates x, y. Both components of r
have the same polynomial and conditions, so one component is derived and used twice.
"""

from functools import cache

import sympy

x, y, l = sympy.symbols("x y l")

# The monomials of (A.1), in the order of its coefficients a_0 ... a_6.
MONOMIALS = tuple(map(sympy.sympify, (1, x, y, x * y, x**2, x**3, x**2 * y)))

# One component of the seven nodal vectors, in the order of (4).
NODAL = sympy.symbols("r_i r_y_i r_j r_x_j r_y_j r_k r_y_k")


def polynomial(coefficients):
    """One component of the field (A.1)."""
    return sum(a * monomial for a, monomial in zip(coefficients, MONOMIALS, strict=True))


def nodal_values(component):
    """Values that (A.2) prescribes for one component of a field, in the order of (4)."""

    def at(function, abscissa):
        return function.subs({x: abscissa, y: 0})

    return [
        at(component, 0),
        at(component.diff(y), 0),
        at(component, l / 2),
        at(component.diff(x), l / 2),
        at(component.diff(y), l / 2),
        at(component, l),
        at(component.diff(y), l),
    ]


@cache
def coefficients():
    """a_0 ... a_6 in terms of the nodal values, from solving (A.2); the paper states them as (A.3)."""
    unknowns = sympy.symbols("a_0:7")
    conditions = [
        sympy.Eq(condition, value)
        for condition, value in zip(nodal_values(polynomial(unknowns)), NODAL, strict=True)
    ]
    solution = sympy.solve(conditions, unknowns, dict=True)
    assert len(solution) == 1, "the nodal conditions must fix the polynomial"
    return tuple(sympy.expand(solution[0][a]) for a in unknowns)


def coefficients_printed():
    """(A.3) as printed: r_k in a_1 has the wrong sign (E1)."""
    r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k = NODAL
    return (
        r_i,
        -(5 * r_i - 4 * r_j + r_k + 2 * l * r_x_j) / l,
        r_y_i,
        -(3 * r_y_i - 4 * r_y_j + r_y_k) / l,
        (8 * r_i - 4 * r_j - 4 * r_k + 6 * l * r_x_j) / l**2,
        -(4 * r_i - 4 * r_k + 4 * l * r_x_j) / l**3,
        (2 * r_y_i - 4 * r_y_j + 2 * r_y_k) / l**2,
    )


@cache
def shape_functions():
    """S_1 ... S_7: derivatives of the field with respect to the nodal values."""
    field = sympy.expand(polynomial(coefficients()))
    return tuple(sympy.expand(field.diff(value)) for value in NODAL)
