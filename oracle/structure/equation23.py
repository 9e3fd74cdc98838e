"""Equation (23) in one state, exactly: m q'' + Q_e + Phi_q^T lambda = f, Phi(q) = 0.

Q_e is k(dT) q in the paper. The terms of a scene are sums over its elements, whose mass, force and weight
`element/element.py` derives from their energies.
"""

from dataclasses import dataclass

from flint import fmpq, fmpq_mat

from ..element.element import DOF, Element
from ..element.state import State
from . import constraint
from .scene import piecewise

ZERO = fmpq(0)


@dataclass(frozen=True)
class Equation23:
    """The terms of (23). q'' and lambda are arbitrary and need not solve it."""

    m: fmpq_mat
    Q_e: list
    f: list
    Phi: list
    Phi_q: fmpq_mat
    q_ddot: list
    multipliers: list

    def constraint_force(self):
        """Phi_q^T lambda."""
        return entries(self.Phi_q.transpose() * column(self.multipliers))

    def constraint_force_printed(self):
        """Phi_q lambda as printed (E4), for as many constraints as coordinates."""
        return entries(self.Phi_q * column(self.multipliers))

    def residual(self, force):
        """m q'' + Q_e + force - f, with the constraint force in either form."""
        inertia = entries(self.m * column(self.q_ddot))
        return [sum(terms) - f for *terms, f in zip(inertia, self.Q_e, force, self.f)]

    def solution(self):
        """q'' and lambda from (23) and Phi'' = 0, which is Phi_q q'' = 0.

        The constraints are linear in q and do not depend on time. So this holds at any velocity, and also where q
        violates them.
        """
        n, rows = self.m.nrows(), self.Phi_q.nrows()
        right = [f - Q for f, Q in zip(self.f, self.Q_e)] + [ZERO] * rows
        solution = entries(self.matrix().solve(column(right)))
        return solution[:n], solution[n:]

    def matrix(self):
        """The matrix [[m, Phi_q^T], [Phi_q, 0]] of (23)."""
        n, rows = self.m.nrows(), self.Phi_q.nrows()
        matrix = fmpq_mat(n + rows, n + rows)
        for i in range(n):
            for j in range(n):
                matrix[i, j] = self.m[i, j]
            for k in range(rows):
                matrix[i, n + k] = matrix[n + k, i] = self.Phi_q[k, i]
        return matrix


def of_scene(scene, t, q, q_ddot, multipliers):
    """(23) of a `Scene` at time t."""
    elements = elements_of(scene, t, q)
    return Equation23(
        m=mass(scene, elements),
        Q_e=total(scene, ((first, element.force(element.energy)) for first, element in elements)),
        f=total(scene, [(first, element.gravity_force) for first, element in elements] + [
            (2 * scene.points[point][0][1], [c * piecewise(history, t) for c in force])
            for point, force, history in scene.forces]),
        Phi=constraint.values(scene, q),
        Phi_q=fmpq_mat(constraint.derivative(scene)),
        q_ddot=q_ddot, multipliers=multipliers,
    )


def elements_of(scene, t, q):
    """All elements, each with the index of its first coordinate in q."""
    initial, found = scene.straight(), []
    for rod in scene.rods:
        for k in range(rod.elements):
            first = 2 * (rod.first + 5 * k)
            own = slice(first, first + DOF)
            state = State(
                id=f"{rod.name} {k}", tags=(), what="", l=rod.l, h=rod.h, w=rod.w, direction=tuple(rod.t),
                e0=tuple(initial[own]), e=tuple(q[own]), edot=(ZERO,) * DOF, E=rod.E, nu=rod.nu,
                rho=rod.rho, alpha=rod.alpha, dT=piecewise(rod.history, t), model=rod.model,
                points=(), gravity=tuple(scene.gravity))
            found.append((first, Element(state)))
    return found


def mass(scene, elements):
    """m; the rods are not coupled in it."""
    m = fmpq_mat(scene.size, scene.size)
    for first, element in elements:
        for i in range(DOF):
            for j in range(DOF):
                m[first + i, first + j] += element.mass[i, j]
    return m


def total(scene, parts):
    """Sum of parts, each given with the index of its first coordinate."""
    vector = [ZERO] * scene.size
    for first, part in parts:
        for i, entry in enumerate(part):
            vector[first + i] += entry
    return vector


def column(vector):
    """A list as a matrix of one column."""
    return fmpq_mat([[entry] for entry in vector])


def entries(matrix):
    """A matrix of one column as a list."""
    return [row[0] for row in matrix.tolist()]
