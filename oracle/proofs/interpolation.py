"""The polynomial (A.1), its coefficients (A.3) and the shape functions (3)."""

import sympy
from sympy import expand

from ..element import field
from ..element.field import NODAL, l, x, y


def a_1_is_misprinted():
    """E1. Solving (A.2) for (A.1) gives (A.3), except for the sign of r_k in a_1.

    With a_1 as printed the field does not pass through its node at x = l.
    """
    derived, printed = field.coefficients(), field.coefficients_printed()
    excess = [expand(p - d) for p, d in zip(printed, derived)]
    r_k = NODAL[5]
    assert excess[1] == -2 * r_k / l
    assert [k for k, term in enumerate(excess) if term != 0] == [1]
    residuals = [v - q for v, q in zip(field.nodal_values(field.polynomial(derived)), NODAL)]
    assert not any(map(expand, residuals))
    assert expand(field.polynomial(printed).subs({x: l, y: 0})) == -r_k
    return "E1: a_1 as printed is wrong by -2 r_k/l and places the end x = l at -r_k"


def coefficients_start_at_zero():
    """E5. The polynomial needs a_0: without it the field vanishes at x = y = 0 for any r_i."""
    without = field.polynomial((0, *sympy.symbols("a_1:7")))
    assert len(field.MONOMIALS) == 7
    assert field.nodal_values(without)[0] == 0
    return "E5: the seven coefficients run from 0 to 6; without a_0 the node i stays at the origin"


def printed_shape_functions_hold():
    """(3), (A.4) and (A.5) as printed are the derivatives of the field by its nodal values."""
    a, b = x / l, y / l
    printed = (
        1 - 5 * a + 8 * a**2 - 4 * a**3,
        l * b * (1 - 3 * a + 2 * a**2),
        4 * a - 4 * a**2,
        l * a * (-2 + 6 * a - 4 * a**2),
        l * b * (4 * a - 4 * a**2),
        a - 4 * a**2 + 4 * a**3,
        l * b * (-a + 2 * a**2),
    )
    derived = field.shape_functions()
    assert all(expand(p - d) == 0 for p, d in zip(printed, derived, strict=True))
    return "(3), (A.4), (A.5): the printed shape functions are right"
