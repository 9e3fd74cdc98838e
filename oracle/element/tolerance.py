"""Size of the terms that are added up for each quantity of `fixtures/equations.json`, entry by entry.

The sizes follow from bounds of the shape functions (3) and of their derivatives over the element. The tolerance is a
fraction of the size (`oracle/fixtures/tolerance.py`).
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from ..fixtures import fixture
from ..fixtures.tolerance import LEAST, RELATIVE, absolute


def doubled(seven):
    """A list per nodal vector as a list per nodal coordinate."""
    return [number for number in seven for _ in range(2)]


def outer(factor, a, b):
    """The matrix factor a b^T."""
    return [[factor * u * v for v in b] for u in a]


class Sizes:
    """Bounds from which the terms of one state's quantities are built."""

    def __init__(self, state, values):
        self.state, self.values = state, values
        number = fixture.nearest
        self.l, self.h, self.w, self.E, self.nu, self.rho = (
            number(getattr(state, name)) for name in ("l", "h", "w", "E", "nu", "rho"))
        self.e, self.edot, self.gravity = (
            [abs(number(v)) for v in getattr(state, name)] for name in ("e", "edot", "gravity"))
        l, b = self.l, self.h / 2 / self.l
        # S_1 ... S_7 over 0 <= a <= 1, |y| <= h/2; S_4 by its terms, which cancel to l/5.
        self.N = doubled([1, self.h / 2, 1, l, self.h / 2, 1, self.h / 2])
        x, y = [5 / l, 3 * b, 4 / l, 2, 4 * b, 5 / l, 3 * b], [0, 1, 0, 0, 1, 0, 1]
        self.D = doubled([u + v for u, v in zip(x, y)])
        self.volume = self.l * self.h * self.w
        lam, mu = (abs(number(values[name])) for name in ("17.lambda", "17.mu"))
        self.stiff = lam + 2 * mu
        # 1 - 2 nu carries the rounding of nu.
        self.poisson = 1 / (1 - 2 * self.nu)

    def sum(self, coordinates):
        """Terms of S times nodal coordinates."""
        return max(sum(n * q for n, q in zip(self.N, coordinates)), LEAST)

    @cached_property
    def at_points(self):
        """|dS/dx| + |dS/dy| at the state's points, by coordinate."""
        pairs = zip(self.values["3.S_x"], self.values["3.S_y"])
        return [doubled([abs(fixture.nearest(u)) + abs(fixture.nearest(v)) for u, v in zip(*pair)]) for pair in pairs]

    @cached_property
    def gradients(self):
        """Terms of r_x and r_y at the state's points."""
        return [sum(d * q for d, q in zip(D, self.e)) for D in self.at_points]

    @cached_property
    def strains(self):
        """Terms of a strain, (e^T S_a e - 1)/2, at the state's points."""
        return [(g * g + 1) / 2 for g in self.gradients]

    @property
    def strain(self):
        """Largest of the strains' terms, used for the whole element."""
        return max(self.strains)

    def force(self, i):
        """Terms of Q_e, the integral of (d epsilon/de)^T sigma."""
        return self.poisson * self.stiff * self.volume * self.D[i] * max(self.gradients) * self.strain

    @cached_property
    def coefficients(self):
        """Sizes of the coefficients (A.3) by the vectors that enter them."""
        l = self.l
        size = [max(self.e[2 * n:2 * n + 2]) for n in range(7)]
        r, r_y = max(size[0], size[2], size[5], l * size[3]), max(size[1], size[4], size[6])
        return [r, 12 * r / l, r_y, 8 * r_y / l, 22 * r / l**2, 12 * r / l**3, 8 * r_y / l**2]

    @cached_property
    def polynomial(self):
        """Terms of (A.1): r on the axis, r_x on the axis, r_y, and the derivative of r_y along the axis."""
        c, l = self.coefficients, self.l
        return (c[0] + c[1] * l + c[4] * l**2 + c[5] * l**3, c[1] + 2 * c[4] * l + 3 * c[5] * l**2,
                c[2] + c[3] * l + c[6] * l**2, c[3] + 2 * c[6] * l)

    def inertia(self, i, coordinates):
        """Terms of M times accelerations of this size, and of the weight."""
        return self.rho * self.volume * self.N[i] * (self.sum(coordinates) + sum(self.gravity))

    def accelerations(self, inverse):
        """Terms of the accelerations: |M^-1| times the terms of the forces."""
        load = [self.force(i) + self.rho * self.volume * self.N[i] * sum(self.gravity) for i in range(14)]
        return [sum(abs(fixture.nearest(m)) * f for m, f in zip(row, load)) for row in inverse]


@dataclass(frozen=True)
class Terms:
    """The terms of a quantity in words, and their size; for a point quantity, at each point."""

    what: str
    size: Callable


def each_point(what, size):
    """Terms whose size is equal at all points."""
    return Terms(what, lambda z: [size(z)] * len(z.state.points))


def nodes(z):
    """Terms of the nodal conditions (A.2) on the polynomial."""
    r, r_x, r_y, _ = z.polynomial
    return doubled([r, r_y, r, r_x, r_y, r, r_y])


SUM = "S_i e_i, each at its largest over the element"
SHAPE = "the shape function's own terms at their largest over the element"
POLYNOMIAL = "the terms a_k x^n y^m, with a_k by the nodal vectors that enter it"
STRAIN = "products of two terms of the gradient, (|S_x| + |S_y|) |e|, and 1"
INTEGRAL = "products of two derivatives of S, times the strain's terms, times the volume"
METRIC = "products of derivatives of S at the point"
STIFF = "lambda + 2 mu, over 1 - 2 nu, which carries the rounding of nu"

_metric = Terms(METRIC, lambda z: [outer(1, d, d) for d in z.at_points])
_strains = Terms(STRAIN, lambda z: [[s] * 3 for s in z.strains])
_strain = Terms(STRAIN, lambda z: list(z.strains))
_K_m = Terms(INTEGRAL, lambda z: outer(z.volume * z.strain, z.D, z.D))
_stiffness = Terms(f"{INTEGRAL}, times {STIFF}",
                   lambda z: outer(z.stiff * z.poisson * z.volume * z.strain, z.D, z.D))
_force = Terms("the stress's terms times d epsilon/de, times the volume", lambda z: [z.force(i) for i in range(14)])
_energy = Terms("the product of the stress's and the strain's terms, times half the volume",
                lambda z: z.stiff * z.poisson * z.volume * z.strain**2 / 2)
_law = Terms(STIFF, lambda z: z.stiff * z.poisson)
_coefficients = Terms("nodal vectors over powers of l", lambda z: [[c, c] for c in z.coefficients])

TERMS = {
    "A.1.r": each_point(POLYNOMIAL, lambda z: z.polynomial[0] + z.h * z.polynomial[2]),
    "A.1.r_x": each_point(POLYNOMIAL, lambda z: z.polynomial[1] + z.h * z.polynomial[3]),
    "A.1.r_y": each_point(POLYNOMIAL, lambda z: z.polynomial[2]),
    "A.2.e": Terms(POLYNOMIAL, nodes),
    "A.3.coefficients": _coefficients,
    "A.3.coefficients/printed": _coefficients,
    "A.4.r": each_point(SUM, lambda z: z.sum(z.e)),
    "1.r": each_point(SUM, lambda z: z.sum(z.e)),
    "2.S": each_point(SHAPE, lambda z: [z.N, z.N]),
    "3.S": each_point(SHAPE, lambda z: z.N[::2]),
    "3.S_x": each_point("the terms of S_x and S_y at their largest over the element", lambda z: z.D[::2]),
    "3.S_y": each_point("the terms of S_x and S_y at their largest over the element", lambda z: z.D[::2]),
    "4.nodes": Terms("nodal coordinates, of size 1, unchanged", lambda z: 1.0),
    "5.rdot": each_point(SUM.replace("e_i", "edot_i"), lambda z: z.sum(z.edot)),
    "6.T": Terms("the mass times the velocity's terms squared", lambda z: z.rho * z.volume * z.sum(z.edot)**2 / 2),
    "7.M": Terms("the mass times two shape functions at their largest", lambda z: outer(z.rho * z.volume, z.N, z.N)),
    "8.epsilon_T": Terms("alpha dT itself", lambda z: abs(fixture.nearest(z.state.alpha * z.state.dT))),
    "9.J_0": each_point("three terms of size 1", lambda z: 3.0),
    "9.J": Terms("terms of the gradient, (|S_x| + |S_y|) |e|", lambda z: [[[g] * 2] * 2 for g in z.gradients]),
    "10.epsilon_m": Terms(STRAIN, lambda z: [[[s] * 2] * 2 for s in z.strains]),
    "11.S_a": _metric, "11.S_b": _metric, "11.S_c": _metric,
    "12.epsilon_f": _strains,
    "13.epsilon_1": _strain, "13.epsilon_2": _strain, "13.epsilon_3": _strain,
    "14.epsilon": _strains,
    "15.sigma": Terms(f"the strain's terms times {STIFF}",
                      lambda z: [[z.stiff * z.poisson * s] * 3 for s in z.strains]),
    "16.D": _law,
    "17.lambda": _law,
    "17.mu": Terms("lambda + 2 mu", lambda z: z.stiff),
    "18.U": _energy, "18.U/printed-shear": _energy,
    "19.Q_e": _force, "19.Q_e/printed-shear": _force,
    "20.K": _stiffness, "20.K/printed-shear": _stiffness,
    "21.K_1": _K_m, "21.K_2": _K_m, "21.K_3": _K_m, "21.K_3/printed": _K_m,
    "21.S_a1": _metric, "21.S_b1": _metric, "21.S_c1": _metric,
    "22.eddot": Terms("the terms of Q_e and Q_w through |M^-1|", lambda z: z.accelerations(z.inverse_mass)),
    "22.residual": Terms("the terms of M a, Q_e and Q_w",
                         lambda z: [z.force(i) + z.inertia(i, z.edot) for i in range(14)]),
    "gravity.Q_w": Terms("the weight times a shape function at its largest",
                         lambda z: [z.rho * z.volume * n * max(sum(z.gravity), 1) for n in z.N]),
    "tangent.dQ_e": _stiffness, "tangent.dQ_e/printed-shear": _stiffness,
    "axis.D_0": _law,
    "axis.epsilon": _strains,
    "axis.U": _energy,
    "axis.Q_e": _force,
    "axis.tangent": _stiffness,
    "uniaxial.D": _law,
    "uniaxial.U": _energy,
    "uniaxial.Q_e": _force,
    "uniaxial.tangent": _stiffness,
}


def tolerances(state, values, inverse_mass):
    """absolute and relative of every quantity of a state."""
    sizes = Sizes(state, values)
    sizes.inverse_mass = inverse_mass
    return {id: {"absolute": absolute(terms.size(sizes)), "relative": RELATIVE} for id, terms in TERMS.items()}
