"""The states of `fixtures/cable.json`: exact and named, each with the reason for it."""

from functools import cache

from flint import fmpq as Q

from ..element.state import State, WEIGHT, field_in, plus, scatter
from ..element.states import (
    AUXETIC_25, BACK_113, BACK_157, BAR, DOWN_46, EAST, NORTH, PENDULUM, RUBBER_49, SCISSOR, SLENDER, SOFT_30,
    STEEL_30, STUBBY, TABLE_1, TABLE_2, UP_37, UP_53, UP_62, UP_81,
)


def nodes(length, coefficients):
    """Nodal coordinates (r_i, r_x_i, r_k, r_x_k) of the field whose n-th vector multiplies x^n."""
    rows = []
    for place in (Q(0), length):
        rows.append([place**n for n in range(4)])
        rows.append([n * place ** (n - 1) if n else Q(0) for n in range(4)])
    return tuple(sum(factor * a[i] for factor, a in zip(row, coefficients)) for row in rows for i in range(2))


def line(direction, origin=(0, 0), stretch=1):
    """Field of an evenly stretched straight axis."""
    return field_in(direction, origin, (stretch, 0))


def arc(direction, curvature, origin=(0, 0), stretch=1):
    """A circular arc to third order in x."""
    k = Q(curvature)
    return field_in(direction, origin, (stretch, 0), (0, k / 2), (-k * k / 6, 0))


def spin(length, coefficients, omega, velocity=(0, 0)):
    """Nodal velocities of a rigid motion with angular velocity omega; `velocity` is that of the origin."""
    turned = [(-omega * v, omega * u) for u, v in coefficients]
    turned[0] = (turned[0][0] + velocity[0], turned[0][1] + velocity[1])
    return nodes(length, turned)


def draw(seed, size, denominator):
    """Eight pseudo-random fractions; equal seeds give equal fractions."""
    return scatter(seed, size, denominator)[:8]


def make(id, tags, what, size, direction, form, *, material, heat=("none", 0), origin=(0, 0), offset=None,
         edot=None, seed=None, at=(Q(3, 8),), gravity=WEIGHT, alpha=None):
    """A state from its initial direction and a field `form`; None means the initial field.

    `offset` is added to the nodal coordinates. Nodal velocities are `edot`, or drawn with `seed`.
    """
    l, h, w = size
    properties = material if alpha is None else material | {"alpha": alpha}
    initial = line(direction, origin)
    e = nodes(l, initial if form is None else form)
    if edot is None:
        edot = (Q(0),) * 8 if seed is None else draw(seed, 16, 8)
    return State(
        id=id, tags=tuple(tags.split()), what=what, l=l, h=h, w=w, direction=direction,
        e0=nodes(l, initial), e=e if offset is None else plus(e, offset), edot=edot,
        **properties, dT=Q(heat[1]), model=heat[0],
        points=tuple((a * l, Q(0)) for a in at), gravity=tuple(map(Q, gravity)),
    )


def undeformed():
    """States without strain: rest, heat with the model "none", and rigid motions."""
    swung, moved, flung = line(DOWN_46), line(UP_53, (Q(3, 2), Q(-1, 4))), line(UP_62, (-2, 1))
    return [
        make("rest-horizontal", "rest", "Table 1, one element for the whole rod, at rest without heat.",
             (Q(1), Q(1, 50), Q(1, 50)), EAST, None, material=TABLE_1, at=(Q(0), Q(3, 8), Q(1, 2), Q(1))),
        make("rest-inclined", "rest", "Table 2, at rest at an incline, away from the origin.",
             SCISSOR, UP_62, None, material=TABLE_2, origin=(Q(1, 4), Q(1, 2))),
        make("rest-heat-none", "rest", "Upright, 200 K that the model leaves out, nu = 0.3, no gravity.",
             BAR, NORTH, None, material=SOFT_30, heat=("none", 200), gravity=(0, 0)),
        make("rigid-swing", "rigid", "Table 1 swung down about its hinge, with that swing's velocity.",
             PENDULUM, EAST, swung, material=TABLE_1, edot=spin(PENDULUM[0], swung, Q(5, 4))),
        make("rigid-turned-inclined", "rigid",
             "Turned from its incline and moved, with that motion's velocity; nu = 0.3.",
             STUBBY, BACK_113, moved, material=SOFT_30, edot=spin(STUBBY[0], moved, Q(-3, 2), (Q(1, 2), 2))),
        make("rigid-turned-slender", "rigid slender", "l/h = 1000, turned and moved, two points.",
             SLENDER, UP_37, flung, material=STEEL_30, edot=spin(SLENDER[0], flung, Q(1, 2)),
             at=(Q(1, 8), Q(3, 4))),
    ]


def stretched():
    """Straight axes, stretched evenly and unevenly."""
    uneven = field_in(DOWN_46, (0, 0), (Q(9, 10), 0), (Q(1, 16), 0))
    return [
        make("stretch-horizontal", "even", "Table 1 drawn out by 1/100 along its axis.",
             PENDULUM, EAST, line(EAST, stretch=Q(101, 100)), material=TABLE_1, seed=11),
        make("stretch-inclined-1d", "even", "Inclined, stretched, heated in the 1D model.",
             BAR, UP_53, line(UP_53, stretch=Q(5, 4)), material=SOFT_30, heat=("1d", 100), seed=12),
        make("stretch-turned-2d", "even", "Compressed, turned, cooled in the 2D model, nu = 0.49.",
             STUBBY, UP_62, line(UP_53, (0, 1), Q(7, 8)), material=RUBBER_49, heat=("2d", -120), seed=13),
        make("stretch-uneven", "straight", "Straight, with a stretch that grows along the axis.",
             BAR, DOWN_46, uneven, material=SOFT_30, seed=14, at=(Q(1, 4), Q(7, 8))),
    ]


def heated():
    """Heated elements: at the stress-free stretch 1 + alpha dT, and held at their length."""

    def expanded(model, id, size, direction, turned, stretch, dT, material, **more):
        verb = "Heated" if dT > 0 else "Cooled"
        return make(id, f"stress-free {more.pop('tag', '')}", f"{verb}, and free of stress at the stretch {stretch}.",
                    size, direction, line(turned, (Q(1, 2), 0), stretch), material=material,
                    heat=(model, dT), alpha=(stretch - 1) / dT, **more)

    return [
        expanded("2d", "free-heat-horizontal-2d", PENDULUM, EAST, EAST, Q(101, 100), 200, TABLE_1, seed=21),
        expanded("1d", "free-heat-turned-1d", SCISSOR, UP_81, DOWN_46, Q(11, 10), 150, TABLE_2, seed=24),
        expanded("1d", "free-cold-slender-1d", SLENDER, UP_37, UP_37, Q(9, 10), -50, STEEL_30, tag="slender"),
        make("sudden-heat-horizontal-2d", "blocked", "Table 1 at the paper's sudden 200 K.",
             PENDULUM, EAST, None, material=TABLE_1, heat=("2d", 200)),
        make("sudden-cold-scissor-1d", "blocked", "Table 2 at 77 degrees, sudden -150 K.",
             SCISSOR, UP_81, None, material=TABLE_2, heat=("1d", -150), seed=32),
    ]


def bent():
    """Curved axes. The first two differ only in the thermal model, which does not matter for an axis."""
    pair = {"material": SOFT_30, "seed": 42, "at": (Q(5, 8), Q(1, 16))}
    form = arc(UP_53, Q(1, 4), stretch=Q(21, 20))
    return [
        make("bending-inclined-1d", "bent", "Inclined and strongly bent, heated in the 1D model.",
             BAR, UP_53, form, heat=("1d", 60), **pair),
        make("bending-inclined-2d", "bent", "The same in the 2D model: the values are the same.",
             BAR, UP_53, form, heat=("2d", 60), **pair),
        make("bending-horizontal", "bent", "Table 1 bent downwards like a swinging pendulum, no heat.",
             PENDULUM, EAST, arc(EAST, Q(-1, 4)), material=TABLE_1, seed=41),
        make("bending-slender-2d", "bent slender", "l/h = 1000, bent and heated, nu = 0.3.",
             SLENDER, UP_37, arc(UP_37, Q(1, 10)), material=STEEL_30, heat=("2d", 120), seed=44),
        make("half-turn", "large", "Nearly a half circle, turned far from its initial direction, nu = 0.49.",
             BAR, BACK_157, line(EAST, (1, 1)), material=RUBBER_49, heat=("2d", -80), seed=43,
             offset=tuple(map(Q, (0, 0, -1, 1, Q(-3, 2), Q(1, 8), Q(-7, 8), Q(-9, 8))))),
        make("inflected", "large", "Both ends turned steeply to one side: an S.",
             STUBBY, UP_37, line(UP_37), material=SOFT_30, seed=45, at=(Q(1, 4), Q(1, 2), Q(13, 16)),
             offset=tuple(map(Q, (0, 0, Q(-3, 4), Q(3, 4), 0, 0, Q(-5, 8), Q(3, 4))))),
    ]


def arbitrary():
    """Arbitrary nodal coordinates: no term of any quantity vanishes."""
    return [
        make("random-stubby-none", "random", "l/h = 2, nu = 0.3, no heat.",
             STUBBY, UP_53, None, material=SOFT_30, offset=draw(51, 8, 16), seed=61, at=(Q(1, 8), Q(5, 8))),
        make("random-bar-2d", "random", "l/h = 8, nu = 0.3, cooled in the 2D model, gravity aslant.",
             BAR, BACK_113, None, material=SOFT_30, heat=("2d", -200), offset=draw(53, 8, 16), seed=63,
             gravity=(3, -4), at=(Q(1, 16),)),
        make("random-bar-1d", "random", "l/h = 8, nu = 0.49, heated in the 1D model.",
             BAR, DOWN_46, None, material=RUBBER_49, heat=("1d", 160), offset=draw(54, 8, 16), seed=64,
             at=(Q(13, 16),)),
        make("random-auxetic-1d", "random", "nu = -1/4 and alpha < 0, heated in the 1D model.",
             BAR, UP_81, None, material=AUXETIC_25, heat=("1d", 180), offset=draw(58, 8, 16), seed=69,
             at=(Q(5, 16),)),
        make("random-pendulum-2d", "random", "Table 1 at its 200 K with arbitrary small nodal displacements.",
             PENDULUM, EAST, line(DOWN_46), material=TABLE_1, heat=("2d", 200), offset=draw(55, 8, 256),
             seed=65, at=(Q(9, 16),)),
        make("random-slender-2d", "random slender", "l/h = 1000, nu = 0.3, heated in the 2D model.",
             SLENDER, UP_62, None, material=STEEL_30, heat=("2d", 40), offset=draw(56, 8, 16), seed=66,
             at=(Q(3, 16),)),
    ]


@cache
def states():
    """All states of the fixture, in its order."""
    return undeformed() + stretched() + heated() + bent() + arbitrary()
