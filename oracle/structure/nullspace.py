"""The structure of a scene in free coordinates, q = q_0 + B z: motion from the energies alone.

The columns of B span the null space of Phi_q. The constraints are linear in q and hold at q_0, so that every z
satisfies them, and their forces do no work in any z'. With the kinetic energy z'^T (B^T m B) z'/2, the strain energy
U(q, t), which depends on time through the heat, and the work of weight and point forces,

    B^T m B z'' = B^T (f(t) - dU/dq).

The multipliers follow afterwards from (23): Phi_q^T lambda = f - dU/dq - m q''.
"""

from functools import cached_property

import numpy as np
import scipy

from ..fixtures.fixture import each, nearest, to_sympy
from ..motion.beam import HEATED_DIRECTIONS, Beam, by_components, stress_and_energy
from .constraint import Clamp, Fix, Pin, Slide, constraints, derivative, vector
from .scene import piecewise


def floats(numbers):
    """Nested lists of rational numbers as nested lists of the nearest f64."""
    return each(nearest, numbers)


class Structure:
    """A `Scene` in floating point."""

    def __init__(self, scene):
        self.scene, n = scene, scene.size
        self.q_0 = np.array(floats(scene.straight()))
        self.Phi_q = np.array(floats(derivative(scene)))
        self.B = scipy.linalg.null_space(self.Phi_q)
        self.mass, self.weight = np.zeros((n, n)), np.zeros(n)
        beams = [Beam(rod.elements, *map(to_sympy, (rod.L, rod.h, rod.w, rod.rho))) for rod in scene.rods]
        points = [len(beam.volumes) for beam in beams]
        self.gradient = np.zeros((4, sum(points), n))
        # Squared stress-free stretches are 1 + heated @ dT; dT has one entry per rod.
        self.heated = np.zeros((2, sum(points), len(beams)))
        for k, (rod, beam) in enumerate(zip(scene.rods, beams)):
            own = slice(2 * rod.first, 2 * (rod.first + rod.vectors))
            at = slice(sum(points[:k]), sum(points[:k + 1]))
            self.mass[own, own] = np.kron(beam.mass, np.eye(2))
            self.weight[own] = np.kron(beam.weight, floats(scene.gravity))
            self.gradient[:, at, own] = by_components(beam.gradient).reshape(4, points[k], -1)
            for direction, heated in enumerate(HEATED_DIRECTIONS[rod.model]):
                self.heated[direction, at, k] = 2 * heated * nearest(rod.alpha)
        self.gradient = self.gradient.reshape(-1, n)

        def at_points(value):
            """A property of the rods at all Gauss points."""
            return np.repeat([nearest(value(rod)) for rod in scene.rods], points)

        nu = at_points(lambda rod: rod.nu)
        stress, density, heating = stress_and_energy("nu" if nu.any() else 0)
        self.poisson = (nu,) if nu.any() else ()
        self.stress, self.density, self.heating = stress, density, heating
        mu = at_points(lambda rod: rod.E / (2 * (1 + rod.nu)))
        self.volumes = mu * np.concatenate([beam.volumes for beam in beams])  # times mu
        self.histories = [floats(rod.history) for rod in scene.rods]
        self.forces = []
        for point, force, history in scene.forces:
            generalized = np.zeros(n)
            first = 2 * scene.points[point][0][1]
            generalized[first:first + 2] = floats(force)
            self.forces.append((generalized, floats(history)))

    # Energies and forces at coordinates q.

    def arguments(self, t, q):
        """J and C_T at the Gauss points, the arguments of the functions of `stress_and_energy`."""
        C_T = 1 + self.heated @ [piecewise(history, t) for history in self.histories]
        return (*(self.gradient @ q).reshape(4, -1), *C_T, *self.poisson)

    def elastic_force(self, t, q):
        """dU/dq."""
        return np.concatenate(self.stress(*self.arguments(t, q))) * np.tile(self.volumes, 4) @ self.gradient

    def applied_force(self, t):
        """f: weight and point forces."""
        return self.weight + sum(force * piecewise(history, t) for force, history in self.forces)

    def energies(self, t, q, v):
        """Kinetic, strain and potential energy; the potential of the weight is zero at height zero."""
        strain = self.volumes @ self.density(*self.arguments(t, q))
        return np.array([v @ self.mass @ v / 2, strain, -self.weight @ q])

    # In free coordinates z.

    @cached_property
    def free(self):
        """Matrices of the motion in z."""
        return FreeCoordinates(self)

    def strained(self, t, z):
        """J and C_T at q_0 + B z, as in `arguments`, and the factors of the point forces."""
        C_T = 1 + self.heated @ [piecewise(history, t) for history in self.histories]
        J = (self.free.J_0 + self.free.gradient @ z).reshape(4, -1)
        return (*J, *C_T, *self.poisson), [piecewise(history, t) for _, history in self.forces]

    def acceleration(self, t, z):
        """z''."""
        return self.free.acceleration(*self.strained(t, z), self.stress)

    def rates(self, t, z, v):
        """z''; dU/d(dT) of each rod (times dT' the power of heating); power of the point forces."""
        arguments, factors = self.strained(t, z)
        along, across = self.heating(*arguments)
        heating = (self.volumes * along) @ self.heated[0] + (self.volumes * across) @ self.heated[1]
        power = sum(factor * (force @ v) for force, factor in zip(self.free.forces, factors))
        return np.concatenate([self.free.acceleration(arguments, factors, self.stress), heating, [power]])

    # Constraint forces.

    def multipliers(self, t, q, acceleration):
        """lambda from (23), whose residual must vanish."""
        missing = self.applied_force(t) - self.elastic_force(t, q) - self.mass @ acceleration
        found = np.linalg.solve(self.Phi_q @ self.Phi_q.T, self.Phi_q @ missing)
        rest = missing - self.Phi_q.T @ found
        assert abs(rest).max() < 1e-9 * max(1, abs(self.elastic_force(t, q)).max()), "(23) must hold"
        return found

    def constraint_forces(self, q, multipliers):
        """Forces of supports by point, moments of clamps by point, and forces of pins by point and rod."""
        reactions, moments, pins, row = {}, {}, {}, 0
        for constraint in constraints(self.scene):
            point, count = constraint.point, len(constraint.rows())
            part = multipliers[row:row + count]
            row += count
            match constraint:
                case Pin():
                    on = pins.setdefault(point, {})
                    for rod, force in zip(constraint.rods, (part, -part)):
                        on[rod.name] = on.get(rod.name, 0) + force
                case Fix():
                    force = -part * np.eye(2)["xy".index(constraint.axis)]
                    reactions[point] = reactions.get(point, 0) + force
                case Slide():
                    reactions[point] = reactions.get(point, 0) - part * floats(constraint.normal)
                case Clamp():
                    # The force -lambda t_0 on r_y turns the rod with the moment r_y x (-lambda t_0).
                    (r_x, r_y), (t_x, t_y) = vector(q, constraint.vector), floats(constraint.rod.t)
                    moments[point] = -part[0] * (r_x * t_y - r_y * t_x)
        return reactions, moments, pins

    def at_points(self, q):
        """The nodal vector r, or its rate, at each point of the scene."""
        return {point: vector(q, meeting[0][1]) for point, meeting in self.scene.points.items()}


class FreeCoordinates:
    """Matrices of a `Structure` in z."""

    def __init__(self, structure):
        B = structure.B
        inverse = scipy.linalg.cho_factor(B.T @ structure.mass @ B)
        self.J_0, self.gradient = structure.gradient @ structure.q_0, structure.gradient @ B
        weights = np.tile(structure.volumes, 4)
        self.by_stress = -scipy.linalg.cho_solve(inverse, self.gradient.T * weights)
        self.by_weight = scipy.linalg.cho_solve(inverse, B.T @ structure.weight)
        self.forces = [B.T @ force for force, _ in structure.forces]
        self.by_forces = [scipy.linalg.cho_solve(inverse, force) for force in self.forces]

    def acceleration(self, arguments, factors, stress):
        """z'' from stress, weight and point forces."""
        result = self.by_stress @ np.concatenate(stress(*arguments)) + self.by_weight
        for by_force, factor in zip(self.by_forces, factors):
            result += by_force * factor
        return result
