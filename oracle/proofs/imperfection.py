"""Stress-free deviations of the initial shape: strains are measured from those of the deviated element."""

from dataclasses import replace

from flint import fmpq, fmpq_mat

from ..element.element import DOF, E_SYMBOLS, NAMES, PLANE, Element
from ..element.states import states


def deviation_is_a_constant_stiffness():
    """Energy of E - E_dev - eps_T, differentiated: with A = K of (20) at e_dev, cold, the force is Q_e - A e.

    A rotation of the deviated element, with any translation, takes no force; the tangent is that of the straight element less A; and over a
    step the middle's force does the work of the change of energy.
    """
    state = next(state for state in states() if state.id == "random-bar-2d")
    assert state.nu != 0 and state.dT != 0 and 0 not in state.direction
    element, cold = Element(state), Element(replace(state, dT=fmpq(0)))
    deviated = list(state.e)
    strain, taken_off = element.mechanical_strain(E_SYMBOLS), element.mechanical_strain(deviated)

    def energy(heat):
        """Integral of lambda/2 (tr E)^2 + mu E:E."""
        E = [[strain[i][j] - taken_off[i][j] - heat[i][j] for j in PLANE] for i in PLANE]
        squares = sum(E[i][j] ** 2 for i in PLANE for j in PLANE)
        return element.integral(element.lam / 2 * (E[0][0] + E[1][1]) ** 2 + element.mu * squares)

    def at(polynomial, e):
        return polynomial(0, 0, *e)

    def force(polynomial, e):
        return [at(polynomial.derivative(name), e) for name in NAMES[2:]]

    none = [[fmpq(0)] * 2] * 2
    hot, without_heat = energy(element.thermal_strain), energy(none)
    A = cold.K(4 * cold.mu)
    other = [e + fmpq(7 * k % 5 - 2, 40) for k, e in enumerate(state.e)]
    assert at(without_heat, deviated) == 0 and not any(force(without_heat, deviated)), "no stress at the start"
    c, s = fmpq(5, 13), fmpq(12, 13)
    moved = [e for k in range(0, DOF, 2) for e in (c * deviated[k] - s * deviated[k + 1], s * deviated[k] + c * deviated[k + 1])]
    for k in (0, 4, 10):
        moved[k], moved[k + 1] = moved[k] + 3, moved[k + 1] - 2
    assert at(without_heat, moved) == 0 and not any(force(without_heat, moved)), "none after a rigid motion"
    for e in (deviated, other):
        less = [row[0] for row in (A * fmpq_mat([[x] for x in e])).tolist()]
        assert force(hot, e) == [q - a for q, a in zip(force(element.energy, e), less)], "the force is Q_e - A e"
    tangents = [[[at(k, other) for k in row] for row in element.hessian(U)] for U in (hot, element.energy)]
    assert fmpq_mat(tangents[0]) == fmpq_mat(tangents[1]) - A
    difference = [at(hot, e) - at(element.energy, e) for e in (deviated, other)]
    middle = fmpq_mat([[(a + b) / 2] for a, b in zip(deviated, other)])
    step = fmpq_mat([[b - a for a, b in zip(deviated, other)]])
    assert difference[1] - difference[0] == -(step * A * middle)[0, 0]
    return "imperfection: strains less those of the deviated shape are Q_e - A e with a constant A = K(e_dev); no force in a rigid motion"
