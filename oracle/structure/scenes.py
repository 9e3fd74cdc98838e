"""The scenes of `fixtures/structure.json`. Directions come from Pythagorean triples, so that lengths are rational."""

SOFT = {"E": 2e8, "nu": 0.0, "rho": 7750.0, "alpha": 2.85e-5}
LIGHT = {"E": 1.5e8, "nu": 0.0, "rho": 2750.0, "alpha": 4e-5}
RUBBERY = {"E": 1.2e8, "nu": 0.3, "rho": 4800.0, "alpha": 1e-4}
STIFFER = {"E": 2.5e8, "nu": 0.2, "rho": 7800.0, "alpha": 1.2e-5}

SQUARE = {"height": 0.02, "width": 0.02}
FLAT = {"height": 0.025, "width": 0.016}

WARM = {"model": "2d", "history": [[0.0, 0.0], [0.1, 150.0], [0.3, -50.0]]}
COLD = {"model": "1d", "history": [[0.05, 0.0], [0.2, -80.0], [0.4, 60.0]]}
HOT = {"model": "2d", "history": [[0.0, 0.0], [0.2, 180.0], [0.25, 180.0], [0.45, 20.0]]}
MILD = {"model": "1d", "history": [[0.0, 0.0], [0.1, -40.0], [0.3, 90.0]]}

PUSH = [[0.0, 0.0], [0.05, 1.0], [0.35, -0.5]]


def scene(title, *, material, section, temperature, points, rods, supports, forces, probes=()):
    """A scene of 0.5 s with multipliers and gravity, output every 0.025 s."""
    return {
        "schema": "ancf-scene/1",
        "title": title,
        "material": material,
        "section": section,
        "points": points,
        "rods": rods,
        "supports": supports,
        "gravity": [0.0, -9.8],
        "forces": forces,
        "temperature": temperature,
        "time": {"end": 0.5, "step": 0.0001, "method": "generalized-alpha"},
        "constraints": "multipliers",
        "output": {"interval": 0.025},
        "probes": list(probes),
    }


def scissor(elements, supports, title, probes=()):
    """Two rods pinned at their middles: along (3, 4)/5, 1 m, and along (-5, 12)/13, 1.3 m."""
    one, two = elements
    return scene(
        title, material=SOFT, section=SQUARE, temperature=WARM,
        points={"a": [0.2, 0.3], "b": [0.8, 1.1], "c": [0.75, 0.1], "d": [0.25, 1.3]},
        rods=[
            {"name": "one", "from": "a", "to": "b", "pivot": "m", "elements": one},
            {"name": "two", "from": "c", "to": "d", "pivot": "m", "elements": two,
             "material": LIGHT, "section": FLAT, "temperature": COLD},
        ],
        supports=supports,
        forces=[{"point": "b", "force": [6.0, -15.0], "history": PUSH}],
        probes=probes,
    )


def knee(elements, title, probes=()):
    """Two rods pinned at an end, clamped on the left: along (12, 5)/13, 0.65 m, and (4, -3)/5, 1 m."""
    one, two = elements
    return scene(
        title, material=RUBBERY, section=SQUARE, temperature=HOT,
        points={"p": [-0.1, 0.2], "k": [0.5, 0.45], "s": [1.3, -0.15]},
        rods=[
            {"name": "upper", "from": "p", "to": "k", "elements": one},
            {"name": "lower", "from": "k", "to": "s", "elements": two,
             "material": STIFFER, "section": FLAT, "temperature": MILD},
        ],
        supports=[
            {"point": "p", "fix": ["x", "y"], "clamp": "upper"},
            {"point": "s", "slide": [12.0, -5.0]},
        ],
        forces=[{"point": "s", "force": [-4.0, 3.0], "history": PUSH}],
        probes=probes,
    )


def exact_scissor():
    """Scissor of rods with one and two elements: the pivot is node j of (4) in one rod, a node between elements in the other."""
    slide = [{"point": "d", "slide": [4.0, 3.0]}]
    return scissor((1, 2), slide, "two rods pinned at their middles, one end on an inclined slide")


def exact_knee():
    """Knee of rods with two elements and one."""
    return knee((2, 1), "a clamped rod pinned to one on a slide, nu not zero")


def probes(points, supports, pins):
    """Probes for position and velocity of every point, every reaction, and the force on every rod at every pin."""
    found = [
        {"name": point, "point": point,
         "of": ["position", "velocity"] + ["reaction"] * (point in supports)} for point in points
    ]
    return found + [
        {"name": f"{point}-{rod}", "point": point, "rod": rod, "of": ["reaction"]}
        for point, rods in pins.items() for rod in rods
    ]


def moving_scissor(elements):
    """Scissors hinged at a, with one end on a slide: the two rods fold together."""
    supports = [{"point": "a", "fix": ["x", "y"]}, {"point": "d", "slide": [-3.0, 4.0]}]
    return scissor(elements, supports, "scissors with a hinge and a slide, each rod with its own heat",
                   probes("abcdm", "ad", {"m": ("one", "two")}))


def moving_knee(elements):
    """The knee with probes."""
    return knee(elements, "a clamped rod pinned to one on a slide, nu not zero",
                probes("pks", "ps", {"k": ("upper", "lower")}))
