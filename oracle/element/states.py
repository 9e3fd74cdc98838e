"""The states of `fixtures/equations.json`: exact and named, each with the reason for it."""

from functools import cache

from flint import fmpq as Q

from .state import field_in, make, scatter, spin, straight

# Directions (cos, sin) from Pythagorean triples.
EAST = (Q(1), Q(0))
NORTH = (Q(0), Q(1))
UP_53 = (Q(3, 5), Q(4, 5))
BACK_113 = (Q(-5, 13), Q(12, 13))
UP_62 = (Q(8, 17), Q(15, 17))
DOWN_46 = (Q(20, 29), Q(-21, 29))
UP_37 = (Q(4, 5), Q(3, 5))
BACK_157 = (Q(-12, 13), Q(-5, 13))
UP_81 = (Q(9, 41), Q(40, 41))

TABLE_1 = {"E": Q(2 * 10**8), "nu": Q(0), "rho": Q(7750), "alpha": Q(57, 2 * 10**6)}
TABLE_2 = {"E": Q(7 * 10**10), "nu": Q(0), "rho": Q(2750), "alpha": Q(23, 10**6)}
# Moduli for which lambda and mu are whole numbers.
SOFT_30 = {"E": Q(2600), "nu": Q(3, 10), "rho": Q(1200), "alpha": Q(1, 2000)}
NEARLY_50 = {"E": Q(14999 * 10**2), "nu": Q(4999, 10000), "rho": Q(1000), "alpha": Q(1, 4000)}
STEEL_30 = {"E": Q(208 * 10**9), "nu": Q(3, 10), "rho": Q(7800), "alpha": Q(1, 80000)}
RUBBER_49 = {"E": Q(149 * 10**4), "nu": Q(49, 100), "rho": Q(1000), "alpha": Q(1, 4000)}
# Thickens under tension, shortens when heated; lambda is negative.
AUXETIC_25 = {"E": Q(1800), "nu": Q(-1, 4), "rho": Q(1200), "alpha": Q(-1, 2000)}

# Sizes (l, h, w): half of Table 1's rod, an eighth of Table 2's, and others with l/h = 2, 8, 1000.
PENDULUM = (Q(1, 2), Q(1, 50), Q(1, 50))
SCISSOR = (Q(1, 4), Q(1, 50), Q(1, 50))
STUBBY = (Q(2), Q(1), Q(1, 2))
BAR = (Q(4), Q(1, 2), Q(1, 4))
SLENDER = (Q(5), Q(1, 200), Q(1, 100))


def undeformed():
    """States without mechanical strain: rest, and rigid motions."""
    swung = straight(DOWN_46)
    moved = straight(UP_53, (Q(3, 2), Q(-1, 4)))
    flung = straight(UP_62, (-2, 1))
    return [
        make("rest-horizontal", "rest", "Table 1, one element for the whole rod, at rest without heat.",
             (Q(1), Q(1, 50), Q(1, 50)), EAST, None, material=TABLE_1),
        make("rest-inclined", "rest", "Table 2, at rest at an incline, away from the origin.",
             SCISSOR, UP_62, None, material=TABLE_2, origin=(Q(1, 4), Q(1, 2))),
        make("rest-vertical", "rest", "Upright, nu = 0.3, no gravity.",
             BAR, NORTH, None, material=SOFT_30, gravity=(0, 0)),
        make("rigid-swing", "rigid", "Table 1 swung down about its hinge, with that swing's velocity.",
             PENDULUM, EAST, swung, material=TABLE_1, edot=spin(PENDULUM[0], swung, Q(5, 4))),
        make("rigid-turned-inclined", "rigid",
             "Turned from its incline and moved, with that motion's velocity; nu = 0.3.",
             STUBBY, BACK_113, moved, material=SOFT_30,
             edot=spin(STUBBY[0], moved, Q(-3, 2), (Q(1, 2), 2))),
        make("rigid-turned-slender", "rigid slender", "l/h = 1000, turned and moved, two points.",
             SLENDER, UP_37, flung, material=STEEL_30, edot=spin(SLENDER[0], flung, Q(1, 2)),
             at=[(Q(1, 8), Q(1, 4)), (Q(3, 4), Q(-3, 8))]),
    ]


def stretched():
    """Uniform stretch and shear."""
    return [
        make("stretch-horizontal", "uniform", "Table 1 drawn out by 1/100 along its axis.",
             PENDULUM, EAST, straight(EAST, axial=Q(101, 100)), material=TABLE_1, seed=11),
        make("stretch-inclined-1d", "uniform", "Inclined, stretched on both axes, heated in the 1D model.",
             BAR, UP_53, straight(UP_53, axial=Q(5, 4), thickness=Q(7, 8)), material=SOFT_30,
             heat=("1d", 100), seed=12),
        make("stretch-inclined-2d", "uniform", "Inclined, compressed, turned, cooled in the 2D model.",
             STUBBY, UP_62, straight(UP_53, (0, 1), axial=Q(7, 8), thickness=Q(5, 4)),
             material=RUBBER_49, heat=("2d", -120), seed=13),
        make("shear-horizontal", "uniform", "Simple shear of a quarter, no heat.",
             STUBBY, EAST, straight(EAST, slip=Q(1, 4)), material=SOFT_30, seed=14),
        make("shear-inclined-2d", "uniform", "Simple shear of an inclined element, heated in the 2D model.",
             BAR, DOWN_46, straight(DOWN_46, slip=Q(-1, 2)), material=SOFT_30,
             heat=("2d", 80), seed=15, at=[(Q(1, 4), Q(3, 8)), (Q(7, 8), Q(-1, 4))]),
    ]


def free_heat():
    """Heated elements at the stress-free stretch sqrt(1 + 2 alpha dT): no force."""

    def expanded(model, id, size, direction, turned, stretch, dT, material, **more):
        alpha = (stretch**2 - 1) / (2 * dT)
        thickness = stretch if model == "2d" else 1
        verb = "Heated" if dT > 0 else "Cooled"
        axes = "in both directions" if model == "2d" else "along its initial axis only"
        return make(id, "stress-free", f"{verb}, and free of stress at the stretch {stretch} {axes}.",
                    size, direction, straight(turned, (Q(1, 2), 0), stretch, thickness),
                    material=material, heat=(model, dT), alpha=alpha, **more)

    return [
        expanded("2d", "free-heat-horizontal-2d", PENDULUM, EAST, EAST, Q(101, 100), 200, TABLE_1, seed=21),
        expanded("2d", "free-heat-inclined-2d", BAR, BACK_113, BACK_113, Q(5, 4), 150, SOFT_30, seed=22),
        expanded("1d", "free-heat-inclined-1d", BAR, UP_53, UP_53, Q(11, 10), 100, SOFT_30, seed=23),
        expanded("1d", "free-heat-turned-1d", SCISSOR, UP_81, DOWN_46, Q(101, 100), 150, TABLE_2, seed=24),
        expanded("2d", "free-cold-inclined-2d", STUBBY, UP_62, UP_53, Q(3, 4), -100, RUBBER_49, seed=25),
        expanded("1d", "free-cold-slender-1d", SLENDER, UP_37, UP_37, Q(9, 10), -50, STEEL_30),
    ]


def blocked_heat():
    """Heated elements that are held and cannot expand."""
    thicker = Q(11, 10)
    alpha_dT = (thicker**2 - 1) / 2 * (1 - SOFT_30["nu"])
    return [
        make("sudden-heat-horizontal-2d", "blocked", "Table 1 at the paper's sudden 200 K, 2D model.",
             PENDULUM, EAST, None, material=TABLE_1, heat=("2d", 200)),
        make("sudden-heat-inclined-1d", "blocked", "Table 1, inclined, sudden 200 K in the 1D model.",
             PENDULUM, DOWN_46, None, material=TABLE_1, heat=("1d", 200), seed=31),
        make("sudden-cold-scissor-2d", "blocked", "Table 2 at 77 degrees, sudden -150 K in the 2D model.",
             SCISSOR, UP_81, None, material=TABLE_2, heat=("2d", -150), seed=32),
        make("sudden-heat-slender-1d", "blocked slender", "l/h = 1000, nu = 0.3, 1D model.",
             SLENDER, BACK_157, None, material=STEEL_30, heat=("1d", 160)),
        make("clamped-heat-2d", "uniaxial", "Held in length, free to thicken: N = -E A alpha dT/(1 - nu^2).",
             BAR, UP_62, straight(UP_62, thickness=thicker), material=SOFT_30,
             heat=("2d", 100), alpha=alpha_dT / 100, seed=33),
    ]


def bent():
    """Curved axes: turned section vectors with the midpoint off the chord."""

    def arc(direction, curvature, origin=(0, 0)):
        """A circular arc with turning section vectors, to the order that the field allows."""
        k = Q(curvature)
        axis = {"x": (1, 0), "x^2": (0, k / 2), "x^3": (-k * k / 6, 0)}
        section = {"y": (0, 1), "xy": (-k, 0), "x^2 y": (0, -k * k / 2)}
        vectors = axis | section
        order = ("x", "y", "xy", "x^2", "x^3", "x^2 y")
        return field_in(direction, origin, *(vectors[name] for name in order))

    return [
        make("bending-horizontal", "bent", "Table 1 bent downwards like a swinging pendulum, no heat.",
             PENDULUM, EAST, arc(EAST, Q(-1, 4)), material=TABLE_1, seed=41),
        make("bending-inclined-1d", "bent", "Inclined and strongly bent, heated in the 1D model.",
             BAR, UP_53, arc(UP_53, Q(1, 4)), material=SOFT_30, heat=("1d", 60),
             seed=42, at=[(Q(5, 8), Q(3, 8))]),
        make("bending-turned-2d", "bent", "Bent, turned far from its initial direction, cooled, nu = 0.49.",
             BAR, BACK_113, arc(UP_53, Q(-1, 8), (1, 1)), material=RUBBER_49, heat=("2d", -80),
             seed=43, at=[(Q(3, 16), Q(-1, 8))]),
        make("bending-slender-2d", "bent slender", "l/h = 1000, bent and heated, nu = 0.3, 2D model.",
             SLENDER, UP_37, arc(UP_37, Q(1, 10)), material=STEEL_30, heat=("2d", 120), seed=44),
    ]


def large():
    """Arbitrary nodal coordinates far from the initial ones: no term of any equation vanishes."""
    return [
        make("random-stubby-none", "random", "l/h = 2, nu = 0.3, no heat.",
             STUBBY, UP_53, None, material=SOFT_30, offset=scatter(51, 12, 8), seed=61,
             at=[(Q(1, 8), Q(3, 8)), (Q(5, 8), Q(-1, 4))]),
        make("random-stubby-1d", "random", "l/h = 2, nu = 0, heated in the 1D model.",
             STUBBY, BACK_157, None, material=SOFT_30 | {"nu": Q(0)}, heat=("1d", 240),
             offset=scatter(52, 12, 8), seed=62, at=[(Q(11, 16), Q(-3, 8))]),
        make("random-bar-2d", "random", "l/h = 8, nu = 0.3, cooled in the 2D model, gravity aslant.",
             BAR, BACK_113, None, material=SOFT_30, heat=("2d", -200), offset=scatter(53, 12, 8),
             seed=63, gravity=(3, -4), at=[(Q(1, 16), Q(7, 16))]),
        make("random-bar-cold-1d", "random", "l/h = 8, nu = 0.49, cooled in the 1D model.",
             BAR, DOWN_46, None, material=RUBBER_49, heat=("1d", -160), offset=scatter(54, 12, 8),
             seed=64, at=[(Q(13, 16), Q(1, 8))]),
        make("random-pendulum-2d", "random", "Table 1 at its 200 K with arbitrary small nodal displacements.",
             PENDULUM, EAST, straight(DOWN_46), material=TABLE_1, heat=("2d", 200),
             offset=scatter(55, 8, 256), seed=65, at=[(Q(9, 16), Q(-1, 4))]),
        make("random-slender-2d", "random slender", "l/h = 1000, nu = 0.3, heated in the 2D model.",
             SLENDER, UP_62, None, material=STEEL_30, heat=("2d", 40), offset=scatter(56, 12, 16),
             seed=66, at=[(Q(3, 16), Q(3, 8))]),
    ]


def seldom():
    """Negative nu and alpha, and heat with the model "none", at arbitrary nodal coordinates."""
    return [
        make("random-auxetic-2d", "random", "nu = -1/4 and alpha < 0, heated in the 2D model.",
             BAR, UP_81, None, material=AUXETIC_25, heat=("2d", 180), offset=scatter(58, 12, 8), seed=69,
             at=[(Q(5, 8), Q(-3, 8))]),
        make("random-heat-none", "random", "l/h = 2, nu = 0.3, 200 K that the model leaves out.",
             STUBBY, DOWN_46, None, material=SOFT_30, heat=("none", 200), offset=scatter(59, 12, 8), seed=70,
             at=[(Q(7, 8), Q(1, 8))]),
    ]


def near_singular():
    """Nearly vanishing divisors: 1 - 2 nu, and the determinant of the deformation gradient."""
    flat = straight(BACK_113, (Q(1, 4), 0), axial=Q(3, 2), thickness=Q(1, 512), slip=Q(1, 8))
    return [
        make("near-singular-incompressible-2d", "random", "nu = 0.4999: lambda is 5000 times mu; heated in the 2D model.",
             STUBBY, UP_37, None, material=NEARLY_50, heat=("2d", 80), offset=scatter(57, 8, 32), seed=67,
             at=[(Q(5, 16), Q(3, 8))]),
        make("near-singular-flat-1d", "uniform", "Pressed to 1/512 of its height, sheared and turned, heated in the 1D model.",
             BAR, UP_62, flat, material=SOFT_30, heat=("1d", 120), seed=68, at=[(Q(7, 16), Q(-3, 8))]),
    ]


@cache
def states():
    """All states of the fixture, in its order."""
    return undeformed() + stretched() + free_heat() + blocked_heat() + bent() + near_singular() + seldom() + large()
