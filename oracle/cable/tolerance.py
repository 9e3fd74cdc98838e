"""Size of the terms that are added up for each quantity of `fixtures/cable.json`, entry by entry.

The quantities divide by lengths of vectors, so that a bound of the terms alone does not suffice. `Size` holds a bound of the
quantity and a bound of its terms, with rules for sums and products.
"""

from dataclasses import dataclass
from math import hypot

from ..element.tolerance import outer
from ..fixtures.tolerance import LEAST, RELATIVE, absolute
from . import ball

ROUNDED = 1e-14  # fraction of its terms that rounding leaves of a vanishing quantity

GRADIENT = "the slopes' terms, |S_x| |e|, against the shortest |r_x| at the points"
SHAPE = "the shape function's own terms at their largest over the element"
ENERGY = f"those of epsilon and kappa: {GRADIENT}"

TERMS = {
    "cable.S": SHAPE, "cable.S_x": SHAPE, "cable.S_xx": SHAPE,
    "cable.r": "S_i e_i, each at its largest over the element",
    "cable.r_x": "S_i_x e_i, each at its largest over the element",
    "cable.r_xx": "S_i_xx e_i, each at its largest over the element",
    "cable.epsilon": "|r_x|'s terms, 1 and alpha dT",
    "cable.kappa": GRADIENT,
    "cable.T": "the mass times the velocity's terms squared",
    "cable.M": "the mass times two shape functions at their largest",
    "cable.U": ENERGY, "cable.Q_e": ENERGY, "cable.tangent": ENERGY,
    "cable.Q_w": "the weight times a shape function at its largest",
    "cable.eddot": "the terms of Q_e and Q_w through |M^-1|",
}


@dataclass(frozen=True)
class Size:
    """Bound of a quantity, and bound of the terms that are added up for it."""

    most: float
    terms: float

    def __add__(self, other):
        return Size(self.most + other.most, self.terms + other.terms)

    def __mul__(self, other):
        both = ROUNDED * self.terms * other.terms  # where both factors vanish except for rounding
        return Size(self.most * other.most, self.terms * other.most + self.most * other.terms + both)


def one(number):
    """Size of a number that is a single term."""
    return Size(number, number)


def slopes(l, e):
    """Bounds of |r_x| and |r_xx|, from the legs of the cubic's control polygon and from their differences."""
    first, last = e[2:4], e[6:8]
    middle = [3 / l * (e[4 + i] - e[i]) - first[i] - last[i] for i in range(2)]
    bend = max(hypot(*(u - v for u, v in zip(*pair))) for pair in ((middle, first), (last, middle)))
    return max(hypot(*first), hypot(*middle), hypot(*last)), 2 / l * bend


def sizes(state, values, inverse_mass):
    """Sizes of the terms of every quantity of a state."""
    number = ball.nearest
    l, h, w, E, rho = (number(getattr(state, name)) for name in ("l", "h", "w", "E", "rho"))
    e, edot = ([number(v) for v in vector] for vector in (state.e, state.edot))
    N, D, H = ([terms[i // 2] for i in range(8)] for terms in (
        (1, l, 1, l), (6 / l, 4, 6 / l, 3), (12 / l**2, 6 / l, 12 / l**2, 6 / l)))

    def total(terms, coordinates):
        return sum(n * abs(q) for n, q in zip(terms, coordinates))

    def points(size):
        return [size] * len(state.points)

    EA_l, EI_l = one(E * h * w * l), one(E * w * h**3 / 12 * l)
    mass, gravity = rho * h * w * l, sum(abs(number(g)) for g in state.gravity)
    shortest = min(hypot(*map(number, r_x)) for r_x in values["cable.r_x"])
    longest, bend = slopes(l, e)
    r_x, r_xx = Size(longest, total(D, e)), Size(bend, total(H, e))
    inverse, two = Size(1 / shortest, r_x.terms / shortest**2), one(2)
    S_x, S_xx = [one(d) for d in D], [one(c) for c in H]
    heat = abs(number(state.alpha * state.dT))
    epsilon = Size(max(abs(longest - 1), abs(shortest - 1)) + heat, r_x.terms + 1 + heat)
    kappa = r_x * r_xx * inverse * inverse

    def epsilon_e(i):
        return S_x[i] * r_x * inverse

    def epsilon_ee(i, j):
        return S_x[i] * S_x[j] * (inverse + r_x * r_x * inverse * inverse * inverse)

    def kappa_e(i):
        return (S_xx[i] * r_x + S_x[i] * r_xx + two * kappa * S_x[i] * r_x) * inverse * inverse

    def kappa_ee(i, j):
        cross = S_xx[i] * S_x[j] + S_x[i] * S_xx[j]
        product = two * r_x * (S_x[i] * kappa_e(j) + kappa_e(i) * S_x[j])
        return (cross + two * kappa * S_x[i] * S_x[j] + product) * inverse * inverse

    def stiffness(i, j):
        axial = epsilon_e(i) * epsilon_e(j) + epsilon * epsilon_ee(i, j)
        return (EA_l * axial + EI_l * (kappa_e(i) * kappa_e(j) + kappa * kappa_ee(i, j))).terms

    force = [(EA_l * epsilon * epsilon_e(i) + EI_l * kappa * kappa_e(i)).terms for i in range(8)]
    load = [force[i] + mass * N[i] * gravity for i in range(8)]
    return {
        "cable.S": points(N[::2]), "cable.S_x": points(D[::2]), "cable.S_xx": points(H[::2]),
        "cable.r": points(total(N, e)), "cable.r_x": points(r_x.terms), "cable.r_xx": points(r_xx.terms),
        "cable.epsilon": points(epsilon.terms), "cable.kappa": points(kappa.terms),
        "cable.T": mass * max(total(N, edot)**2, LEAST) / 2,
        "cable.M": outer(mass, N, N),
        "cable.U": (one(0.5) * (EA_l * epsilon * epsilon + EI_l * kappa * kappa)).terms,
        "cable.Q_e": force,
        "cable.tangent": [[stiffness(i, j) for j in range(8)] for i in range(8)],
        "cable.Q_w": [mass * n * max(gravity, 1) for n in N],
        "cable.eddot": [sum(abs(number(m)) * f for m, f in zip(row, load)) for row in inverse_mass],
    }


def tolerances(state, values, inverse_mass):
    """absolute and relative of every quantity of a state."""
    terms = sizes(state, values, inverse_mass)
    return {id: {"absolute": absolute(size), "relative": RELATIVE} for id, size in terms.items()}
