"""One state of one element, with exact inputs.

A configuration is given as a field r(x, y) that the element can represent, not as typed nodal
vectors. Its nodal coordinates follow from the conditions (A.2).
"""

import random
from dataclasses import dataclass
from functools import cache

from flint import fmpq as Q

from ..fixtures.fixture import from_sympy, to_sympy
from . import field

WEIGHT = (Q(0), Q(-49, 5))


@dataclass(frozen=True)
class State:
    """One element, its material, its motion and the points at which fields are evaluated."""

    id: str
    tags: tuple
    what: str
    l: Q
    h: Q
    w: Q
    direction: tuple
    e0: tuple
    e: tuple
    edot: tuple
    E: Q
    nu: Q
    rho: Q
    alpha: Q
    dT: Q
    model: str
    points: tuple
    gravity: tuple


def nodes(length, coefficients):
    """Nodal coordinates (4) of the field (A.1) whose k-th coefficient vector is given."""
    values = _nodal_values_of_monomials(length)
    return tuple(
        sum(Q(a[i]) * values[k][node] for k, a in enumerate(coefficients))
        for node in range(7)
        for i in range(2)
    )


@cache
def _nodal_values_of_monomials(length):
    """Nodal values (A.2) of each monomial of (A.1) on an element of this length."""
    number = to_sympy(length)
    return [
        [from_sympy(value.subs(field.l, number)) for value in field.nodal_values(monomial)]
        for monomial in field.MONOMIALS
    ]


def turn(direction, vector):
    """Global components of a vector given in an element's own axes."""
    (c, s), (u, v) = direction, vector
    return (c * u - s * v, s * u + c * v)


def field_in(direction, origin, *own):
    """Coefficients of a field. `own` holds the vectors of x, y, xy, x^2, x^3, x^2 y in the axes along `direction`."""
    return [origin, *(turn(direction, vector) for vector in own)]


def straight(direction, origin=(0, 0), axial=1, thickness=1, slip=0):
    """The field origin + R (axial x + slip y, thickness y)."""
    return field_in(direction, origin, (axial, 0), (slip, thickness))


def spin(length, coefficients, omega, velocity=(0, 0)):
    """Nodal velocities of a rigid motion with angular velocity omega; `velocity` is that of the origin."""
    turned = [(-omega * v, omega * u) for u, v in coefficients]
    turned[0] = (turned[0][0] + velocity[0], turned[0][1] + velocity[1])
    return nodes(length, turned)


def scatter(seed, size, denominator):
    """Fourteen pseudo-random fractions k/denominator with |k| <= size; equal seeds give equal fractions."""
    choice = random.Random(seed)
    return tuple(Q(choice.randint(-size, size), denominator) for _ in range(14))


def plus(a, b):
    """Sum of two vectors."""
    return tuple(u + v for u, v in zip(a, b, strict=True))


def make(id, tags, what, size, direction, form, *, material, heat=("none", 0), origin=(0, 0),
         offset=None, edot=None, seed=None, at=None, gravity=WEIGHT, alpha=None):
    """A state from its initial direction and a field `form`; None means the initial field.

    `offset` is added to the nodal coordinates. Nodal velocities are `edot`, or drawn with `seed`.
    """
    l, h, w = size
    properties = material if alpha is None else material | {"alpha": alpha}
    initial = straight(direction, origin)
    e = nodes(l, initial if form is None else form)
    points = at or [(Q(3, 8), Q(1, 4))]
    if edot is None:
        edot = (Q(0),) * 14 if seed is None else scatter(seed, 16, 8)
    return State(
        id=id, tags=tuple(tags.split()), what=what, l=l, h=h, w=w, direction=direction,
        e0=nodes(l, initial), e=e if offset is None else plus(e, offset), edot=edot,
        **properties, dT=Q(heat[1]), model=heat[0],
        points=tuple((a * l, b * h) for a, b in points), gravity=tuple(map(Q, gravity)),
    )
