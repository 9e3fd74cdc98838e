"""The rod of Table 1 on its hinge, with either element: coordinates, accelerations and energies.

The coordinates q are the nodal vectors without the position of the hinge. Several rods are integrated together as
columns of q. `heat` holds the thermal quantities of the strain energy: numbers, or one array each for several rods.
Both components of r have the same mass matrix. The tip's r is the last vector but one.
"""

from math import sqrt

import numpy as np
import scipy
import sympy

from ..cable.element import EPSILON, KAPPA
from .axis import Axis, energy_and_stress
from .beam import HEATED_DIRECTIONS, Beam, by_components, stress_and_energy

TABLE_1 = {
    "L": 1.0, "h": 0.02, "w": 0.02,
    "rho": 7750.0, "E": 2e8, "nu": 0.0, "alpha": 2.85e-5,
    "dT": 200.0, "g": 9.8,
}


class Hinged:
    """A hinged rod: its strains are `strains` @ q, its elastic forces `strains`.T @ stress."""

    def __init__(self, rod, strains, heat, parameters):
        # The hinge holds the first vector, r(0), at the origin.
        self.heat, self.parameters = heat, parameters
        self.mass = np.kron(rod.mass[1:, 1:], np.eye(2))
        self.weight = np.kron(rod.weight[1:], [0.0, -parameters["g"]])
        self.strains = strains
        inverse = scipy.linalg.cho_factor(self.mass)
        self.stress_to_acceleration = -scipy.linalg.cho_solve(inverse, strains.T * self.weights())
        free_fall = scipy.linalg.cho_solve(inverse, self.weight)
        self.free_fall = free_fall.reshape(-1, *[1] * np.ndim(heat[0]))  # shared by all rods

    def acceleration(self, _, q):
        """q'' = M^-1 (weight - Q(q)); the time has no effect."""
        return self.stress_to_acceleration @ self.stresses(self.strains @ q) + self.free_fall

    def energies(self, q, v):
        """Kinetic, strain and potential energy; the potential is zero at the hinge's height."""
        strain = self.strain_energy(self.strains @ q)
        return np.array([(v * (self.mass @ v)).sum(0) / 2, strain, -self.weight @ q])


def sizes(parameters):
    """L, h, w and rho as rational numbers."""
    return [sympy.Rational(str(parameters[name])) for name in ("L", "h", "w", "rho")]


class Plane(Hinged):
    """A hinged rod of the paper's elements. `heat` is the squared stress-free stretches along and across.

    `shear` multiplies the shear part of the energy, as a shear correction factor does; one value per rod.
    """

    def __init__(self, elements, heat, parameters=TABLE_1, shear=None):
        self.elements = elements
        self.mu = parameters["E"] / (2 * (1 + parameters["nu"]))
        self.stress, self.energy_density, _ = stress_and_energy(parameters["nu"], "shear" if shear is not None else 1)
        self.factors = () if shear is None else (shear,)
        rod = Beam(elements, *sizes(parameters))
        self.volumes = rod.volumes
        self.shape = (4, len(rod.volumes), *np.shape(heat)[1:])  # J11, J12, J21, J22 at all Gauss points
        super().__init__(rod, by_components(rod.gradient[:, :, 1:]), heat, parameters)

    @staticmethod
    def heat_of(model):
        """`heat` for a model of Table 1."""
        return [1 + 2 * heated * TABLE_1["alpha"] * TABLE_1["dT"] for heated in HEATED_DIRECTIONS[model]]

    def straight(self, relaxed):
        """Coordinates of the straight rod along x, unstretched or (`relaxed`) free of stress."""
        length = self.parameters["L"] / self.elements
        vectors = np.empty((5 * self.elements + 2, 2))
        for k in range(self.elements):
            vectors[5 * k:5 * k + 7] = [
                (k * length, 0), (0, 1),
                ((k + 0.5) * length, 0), (1, 0), (0, 1),
                ((k + 1) * length, 0), (0, 1),
            ]
        return (vectors * ([sqrt(c) for c in self.heat] if relaxed else 1.0))[1:].ravel()

    def weights(self):
        """Weights of the stresses in the elastic force: modulus times Gauss weight."""
        return self.mu * np.tile(self.volumes, 4)

    def stresses(self, strains):
        """dW/dJ divided by mu."""
        return np.concatenate(self.stress(*strains.reshape(self.shape), *self.heat, *self.factors))

    def strain_energy(self, strains):
        """Integral of W over the rod."""
        density = self.energy_density(*strains.reshape(self.shape), *self.heat, *self.factors)
        return self.mu * self.volumes @ density


class Cable(Hinged):
    """A hinged rod of Euler-Bernoulli elements. `heat` is the thermal strain along the axis."""

    stretch, stretch_stress = energy_and_stress(EPSILON)
    bend, bend_stress = energy_and_stress(KAPPA)

    def __init__(self, elements, heat, parameters=TABLE_1):
        self.elements = elements
        area = parameters["h"] * parameters["w"]
        self.EA, self.EI = parameters["E"] * area, parameters["E"] * area * parameters["h"] ** 2 / 12
        rod = Axis(elements, *sizes(parameters))
        self.stretched, self.bent = rod.stretched, rod.bent
        # g at the points of the axial energy; g, then c, at those of the bending energy; x before y.
        families = [*rod.stretching, *rod.bending]
        strains = np.vstack([np.kron(family[:, 1:], component) for family in families for component in np.eye(2)])
        super().__init__(rod, strains, heat, parameters)

    @staticmethod
    def heat_of(model):
        """`heat` for a model of Table 1."""
        return [HEATED_DIRECTIONS[model][0] * TABLE_1["alpha"] * TABLE_1["dT"]]

    def straight(self, relaxed):
        """Coordinates of the straight rod along x, unstretched or (`relaxed`) free of stress."""
        length = self.parameters["L"] / self.elements
        vectors = np.array([vector for k in range(self.elements + 1) for vector in ((k * length, 0), (1, 0))])
        return (vectors * (1 + self.heat[0] if relaxed else 1.0))[1:].ravel()

    def weights(self):
        """Weights of the stresses in the elastic force: modulus times Gauss weight."""
        return np.concatenate([np.tile(self.EA * self.stretched, 2), np.tile(self.EI * self.bent, 4)])

    def split(self, strains):
        """g at the points of the axial energy, with the heat; g and c at those of the bending energy."""
        axial = 2 * len(self.stretched)
        rods = strains.shape[1:]
        return (*strains[:axial].reshape(2, -1, *rods), *self.heat), strains[axial:].reshape(4, -1, *rods)

    def stresses(self, strains):
        """Derivatives of epsilon^2/2 by g, and of kappa^2/2 by g and c."""
        axial, bending = self.split(strains)
        return np.concatenate([*Cable.stretch_stress(*axial), *Cable.bend_stress(*bending)])

    def strain_energy(self, strains):
        """Gauss sums of EA epsilon^2/2 and EI kappa^2/2."""
        axial, bending = self.split(strains)
        return self.EA * self.stretched @ Cable.stretch(*axial) + self.EI * self.bent @ Cable.bend(*bending)
