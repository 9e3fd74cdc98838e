"""The exact cases of `fixtures/structure.json`: (23) for two structures, and for a square example that shows E4."""

import random
from dataclasses import replace

from flint import fmpq as Q
from flint import fmpq_mat

from ..element.element import Element
from ..element.equations import inputs, nearest_angle
from ..element.state import make, scatter, straight, turn
from ..element.states import DOWN_46, UP_53
from ..fixtures import fixture, tolerance
from . import equation23, scenes
from .constraint import constraints, values
from .equation23 import Equation23, column, entries
from .scene import Scene

RUBBER = {"E": Q(2600), "nu": Q(3, 10), "rho": Q(1200), "alpha": Q(1, 2000)}

LARGEST = "the largest entry"
SOLUTION = "the equations' terms through |A^-1|, A the matrix of (23), once for each of its rows"

# Description, shape (n coordinates, c constraints), unit, and terms of which the tolerance is a fraction.
QUANTITIES = {
    "23.m": ("mass matrix", ["n", "n"], "kg; slopes kg m, kg m^2", LARGEST),
    "23.Q_e": ("elastic force with heat, which the paper writes k(dT) q", ["n"], "N; slopes N m", LARGEST),
    "23.f": ("weight and point forces", ["n"], "N; slopes N m", LARGEST),
    "23.Phi": ("constraint functions", ["c"], "m; clamps 1", "1"),
    "23.Phi_q": ("their derivative by q", ["c", "n"], "1", LARGEST),
    "23.constraint_force": ("Phi_q^T lambda with the given lambda", ["n"], "N; slopes N m", "|Phi_q|^T |lambda|"),
    "23.residual": ("m q'' + Q_e + Phi_q^T lambda - f with the given q'' and lambda", ["n"], "N; slopes N m", "the four terms, |m| |q''| and so on"),
    "23.acceleration": ("q'' that solves (23) with Phi_q q'' = 0", ["n"], "m/s^2; slopes 1/s^2", SOLUTION),
    "23.lambda": ("lambda of the same solution", ["c"], "N; clamps N m", SOLUTION),
    "23.constraint_force/printed": ("Phi_q lambda (E4), for n = c only", ["n"], "N; slopes N m", "|Phi_q| |lambda|"),
    "23.residual/printed": ("m q'' + Q_e + Phi_q lambda - f, for n = c only", ["n"], "N; slopes N m", "the four terms"),
}


def descriptions():
    """The quantities as the fixture describes them."""
    return {
        id: {"equation": "23", "what": what, "shape": shape, "unit": unit,
             "form": "printed" if id.endswith("/printed") else "consistent", "terms": terms}
        for id, (what, shape, unit, terms) in QUANTITIES.items()
    }


def numbers(seed, count, size, denominator):
    """Pseudo-random fractions k/denominator with |k| <= size; equal seeds give equal fractions."""
    choice = random.Random(seed)
    return [Q(choice.randint(-size, size), denominator) for _ in range(count)]


def moved(scene, direction, shift):
    """q of the initial structure after a rotation about the origin and a shift."""
    positions = {2 * (rod.first + k) for rod in scene.rods for k in range(rod.vectors) if k % 5 in (0, 2)}
    q = scene.straight()
    turned = []
    for k in range(0, len(q), 2):
        offset = shift if k in positions else (0, 0)
        turned += [c + d for c, d in zip(turn(direction, q[k:k + 2]), offset)]
    return turned


def cases():
    """All cases."""
    return [
        of_scene("scissor-disturbed", scenes.exact_scissor, "The initial structure with small disturbances.",
                 t=Q(3, 20), seed=1),
        of_scene("scissor-turned", scenes.exact_scissor, "The structure turned by -46.4 degrees, shifted and "
                 "disturbed.", t=Q(1, 40), seed=2, direction=DOWN_46, shift=(Q(1, 2), Q(-1, 4)), size=64),
        of_scene("knee-disturbed", scenes.exact_knee, "The initial structure with small disturbances.",
                 t=Q(9, 40), seed=3),
        of_scene("knee-turned", scenes.exact_knee, "The structure turned by 53.1 degrees, shifted and "
                 "disturbed.", t=Q(2, 5), seed=4, direction=UP_53, shift=(Q(-1, 8), Q(3, 4)), size=64),
        square(),
    ]


def of_scene(id, make_scene, what, *, t, seed, direction=(1, 0), shift=(0, 0), size=4):
    """A case of a scene: its structure moved rigidly, then disturbed by up to size/4096."""
    document = make_scene()
    scene = Scene(document)
    assert not any(values(scene, scene.straight())), "the initial structure must satisfy its constraints"
    n = scene.size
    q = [a + b for a, b in zip(moved(scene, direction, shift), numbers(seed, n, size, 4096))]
    held = constraints(scene)
    rows = [row for constraint in held for row in constraint.rows()]
    q_ddot, multipliers = numbers(seed + 10, n, 64, 8), numbers(seed + 20, len(rows), 400, 8)
    equation = equation23.of_scene(scene, t, q, q_ddot, multipliers)
    assert all(equation.Phi), "every constraint must be violated, or a wrong one could pass"
    demand(scene, equation)
    given = {"t": t, "q": q, "q_ddot": q_ddot, "lambda": multipliers}
    return entry(id, what, {"scene": document, "rows": rows}, given, equation)


def demand(scene, equation):
    """Asserts that a translation moves the whole mass, that the elastic force has no resultant, and that (23) is solved."""
    for i in range(2):
        shift = [Q(0)] * scene.size
        for rod in scene.rods:
            for k in range(rod.vectors):
                shift[2 * (rod.first + k) + i] = Q(int(k % 5 in (0, 2)))
        mass = sum(rod.rho * rod.L * rod.h * rod.w for rod in scene.rods)
        assert (column(shift).transpose() * equation.m * column(shift))[0, 0] == mass
        assert sum(s * force for s, force in zip(shift, equation.Q_e)) == 0
    q_ddot, multipliers = equation.solution()
    solved = replace(equation, q_ddot=q_ddot, multipliers=multipliers)
    assert not any(solved.residual(solved.constraint_force()))
    assert not any(entries(equation.Phi_q * column(q_ddot)))


def square():
    """One element with as many constraints as coordinates, so that the printed Phi_q lambda is defined."""
    state = make("square", "", "", (Q(2), Q(1), Q(1, 2)), DOWN_46, straight(DOWN_46), material=RUBBER,
                 heat=("2d", 40), offset=scatter(5, 8, 32))
    element = Element(state)
    rows = fmpq_mat([numbers(100 + k, 14, 8, 4) for k in range(14)])
    assert rows.det() != 0 and rows != rows.transpose()
    away = column([a - b for a, b in zip(state.e, state.e0)])
    q_ddot, multipliers = numbers(15, 14, 64, 8), numbers(25, 14, 400, 8)
    equation = Equation23(
        m=element.mass, Q_e=element.force(element.energy), f=element.gravity_force,
        Phi=entries(rows * away), Phi_q=rows, q_ddot=q_ddot, multipliers=multipliers)
    cosine, sine = map(fixture.rational, state.direction)
    kept = ("l", "h", "w", "theta", "cos_theta", "sin_theta", "e0", "E", "nu", "rho", "alpha", "dT", "model",
            "gravity")
    both = [
        (fixture.nearest, {"theta": nearest_angle(*state.direction)}),
        (fixture.rational, {"cos_theta": cosine, "sin_theta": sine}),
    ]
    f64, exact = (
        {key: value for key, value in inputs(state, *notation).items() if key in kept} for notation in both)
    given = {"q": list(state.e), "q_ddot": q_ddot, "lambda": multipliers, "Phi_q": rows.tolist()}
    what = ("One element, and 14 constraints Phi = Phi_q (q - e0) that no mechanism has: Phi_q is given, "
            "invertible and not symmetric.")
    return entry("square", what, {"element": f64, "element_exact": exact}, given, equation, printed=True)


def entry(id, what, described, given, equation, printed=False):
    """One case of the fixture."""
    acceleration, multipliers = equation.solution()
    force = equation.constraint_force()
    found = {
        "23.m": equation.m.tolist(),
        "23.Q_e": equation.Q_e,
        "23.f": equation.f,
        "23.Phi": equation.Phi,
        "23.Phi_q": equation.Phi_q.tolist(),
        "23.constraint_force": force,
        "23.residual": equation.residual(force),
        "23.acceleration": acceleration,
        "23.lambda": multipliers,
    }
    if printed:
        wrong = equation.constraint_force_printed()
        assert all(a != b for a, b in zip(force, wrong)), "E4 must show in every entry"
        found |= {"23.constraint_force/printed": wrong, "23.residual/printed": equation.residual(wrong)}
    sizes = sizes_of(equation, acceleration, multipliers, found)
    return {
        "id": id,
        "tags": tags_of(id, described),
        "what": what,
        **described,
        "state": {name: fixture.each(fixture.nearest, value) for name, value in given.items()},
        "exact": {name: fixture.each(fixture.rational, value) for name, value in given.items()},
        "values": {
            name: {
                "exact": fixture.each(fixture.rational, value),
                "f64": fixture.each(fixture.nearest, value),
                "absolute": tolerance.absolute(sizes[name]),
                "relative": tolerance.RELATIVE,
            }
            for name, value in found.items()
        },
    }


TAGS = {
    "pins": "rods pinned to one another, each at its own temperature",
    "slide": "a point held across an inclined direction",
    "fix": "a point held in both directions",
    "clamp": "a section held in its direction",
    "turned": "the whole structure turned from its initial place",
    "square": "as many constraints as coordinates, so that the printed form (E4) has a value",
}


def tags_of(id, described):
    """Tags of a case."""
    supports = {key for support in described.get("scene", {}).get("supports", []) for key in support}
    found = {"pins": "scene" in described, "turned": id.endswith("-turned"), "square": id == "square"}
    return [tag for tag in TAGS if found.get(tag, tag in supports)]


def sizes_of(equation, acceleration, multipliers, found):
    """Size of the terms that are added up for each quantity, entry by entry."""
    n, c = equation.m.nrows(), equation.Phi_q.nrows()

    def absolute(rows):
        return [[abs(entry) for entry in row] for row in rows]

    def times(rows, vector):
        return [sum((m * abs(v) for m, v in zip(row, vector)), Q(0)) for row in rows]

    def plus(*vectors):
        return [sum(map(abs, entries), Q(0)) for entries in zip(*vectors)]

    def largest(name):
        return max(map(abs, tolerance.flat(found[name])))

    m, Phi_q = absolute(equation.m.tolist()), absolute(equation.Phi_q.tolist())
    transposed = [list(column) for column in zip(*Phi_q)]
    force = times(transposed, equation.multipliers)
    others = plus(times(m, equation.q_ddot), equation.Q_e, equation.f)
    # Rounding the matrix and the load of A x = b by one unit changes x by |A^-1| (|A| |x| + |b|), once in each elimination.
    # Accelerations that the constraints hold at zero carry the rounding of the unconstrained ones.
    load = plus(equation.Q_e, equation.f)
    A = [row + column for row, column in zip(m, transposed)] + [row + [Q(0)] * c for row in Phi_q]
    inverse = absolute(equation.matrix().inv().tolist())
    solution = times(inverse, plus(times(A, [*acceleration, *multipliers]), load + [Q(0)] * c))
    unconstrained = times(absolute(equation.m.inv().tolist()), load)
    sizes = {
        **{name: largest(name) for name in ("23.m", "23.Q_e", "23.f", "23.Phi_q")},
        "23.Phi": Q(1),
        "23.constraint_force": force,
        "23.residual": plus(others, force),
        "23.acceleration": [(n + c) * (a + b) for a, b in zip(solution, unconstrained)],
        "23.lambda": [(n + c) * value for value in solution[n:]],
    }
    if n == c:
        printed = times(Phi_q, equation.multipliers)
        sizes |= {"23.constraint_force/printed": printed, "23.residual/printed": plus(others, printed)}
    return {name: fixture.each(fixture.nearest, size) for name, size in sizes.items()}
