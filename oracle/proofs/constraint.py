"""The constraint force of (23)."""

import sympy
from sympy import diff, expand

ROWS, COORDINATES = 2, 4


def printed_constraint_force_has_no_meaning():
    """E4. The force of the constraints Phi(q) = 0 is Phi_q^T lambda; the paper prints Phi_q lambda.

    Phi is arbitrary. The term lambda . Phi of the Lagrangian has the derivative Phi_q^T lambda. That force does the work
    lambda . (Phi_q dq), which is zero for admissible displacements dq. Phi_q lambda has one entry per constraint, not per
    coordinate. Where both numbers are equal it is a wrong force: a point (u, v) held twice on the line v = 0 is pushed
    along the line.
    """
    q = sympy.Matrix(sympy.symbols(f"q_1:{COORDINATES + 1}"))
    dq = sympy.Matrix(sympy.symbols(f"dq_1:{COORDINATES + 1}"))
    multipliers = sympy.Matrix(sympy.symbols(f"lambda_1:{ROWS + 1}"))
    Phi = sympy.Matrix([sympy.Function(f"Phi_{k + 1}")(*q) for k in range(ROWS)])
    Phi_q = Phi.jacobian(q)
    force = Phi_q.T * multipliers
    for coordinate, component in zip(q, force):
        assert expand(component - diff(multipliers.dot(Phi), coordinate)) == 0
    assert expand(force.dot(dq) - multipliers.dot(Phi_q * dq)) == 0
    try:
        Phi_q * multipliers
    except sympy.matrices.exceptions.ShapeError:
        pass
    else:
        raise AssertionError("Phi_q lambda must be undefined for fewer constraints than coordinates")

    u, v = sympy.symbols("u v")
    twice = sympy.Matrix([v, v]).jacobian([u, v])
    admitted = sympy.Matrix([1, 0])
    assert twice * admitted == sympy.zeros(2, 1)
    assert (twice.T * multipliers).dot(admitted) == 0
    assert (twice * multipliers).dot(admitted) == multipliers[1] != 0
    return ("E4: Phi_q^T lambda does no work in an admissible displacement; Phi_q lambda is undefined, or does work")
