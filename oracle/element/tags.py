"""Tags of states: those that follow from the numbers, added to those given by hand."""

from flint import fmpq

# Bound for nearly vanishing divisors: 1 - 2 nu, or the determinant of the deformation gradient.
NEARLY_ZERO = fmpq(1, 40)

WORDS = {
    "rest": "the initial configuration, no heat: U = 0 and Q_e = 0 exactly",
    "rigid": "a rigid motion of it: U = 0 and Q_e = 0 exactly",
    "stress-free": "as wide as its heat makes it: U = 0 and Q_e = 0 exactly",
    "uniform": "stretch or shear, the same all over the element",
    "blocked": "heated and not free to answer",
    "uniaxial": "held in length, free to thicken",
    "bent": "a curved axis",
    "even": "a straight axis, evenly stretched",
    "straight": "a straight axis, unevenly stretched",
    "large": "bent far",
    "random": "arbitrary nodal coordinates: every term of every quantity lives",
    "slender": "l/h = 1000",
    "rotated": "the initial axis is not along the global x",
    "turned": "the line from node i to node k is turned from the initial axis",
    "sheared": "a shear strain in the element's own axes",
    "heated": "dT > 0 and a model that has heat",
    "cooled": "dT < 0 and a model that has heat",
    "1d": "heat strains the axis only", "2d": "heat strains both directions",
    "none": "dT is not zero, and the model leaves it out",
    "contracting": "alpha < 0: shorter when heated",
    "nu": "Poisson's ratio is not zero",
    "auxetic": "Poisson's ratio is negative: thicker when drawn out",
    "moving": "edot is not zero",
    "near-singular": "1 - 2 nu or det J is at most 1/40",
}


def derived(state, shear=(), stretches=()):
    """Tags that follow from the numbers. `shear` holds shear strains in own axes, `stretches` det J, at the state's points."""
    (c, s), e, size = state.direction, state.e, len(state.e)
    last = size - 4  # node k is followed by one slope
    dx, dy = e[last] - e[0], e[last + 1] - e[1]
    hot = state.model != "none"
    found = {
        "rotated": s != 0 or c < 0,
        "turned": c * dy - s * dx != 0 or c * dx + s * dy < 0,
        "sheared": any(shear),
        "heated": hot and state.dT > 0,
        "cooled": hot and state.dT < 0,
        "1d": hot and state.model == "1d",
        "2d": hot and state.model == "2d",
        "none": not hot and state.dT != 0,
        "contracting": state.alpha < 0,
        "nu": state.nu != 0,
        "auxetic": state.nu < 0,
        "moving": any(state.edot),
        "near-singular": min([1 - 2 * state.nu, *map(abs, stretches)]) <= NEARLY_ZERO,
    }
    return [tag for tag, holds in found.items() if holds]


def all_of(state, **seen):
    """Tags given by hand and derived tags, each once."""
    tags = list(dict.fromkeys([*state.tags, *derived(state, **seen)]))
    assert set(tags) <= set(WORDS), "every tag must be explained in WORDS"
    return tags


def of_all(entries):
    """Explanations of the tags that the stored entries have."""
    used = {tag for entry in entries for tag in entry["tags"]}
    return {tag: what for tag, what in WORDS.items() if tag in used}
