"""Motions of structures from rest, with heat and forces that change in time, and their constraint forces.

The coordinates are free (`nullspace.py`): the constraints hold by construction, no multiplier is integrated, and the
constraint forces follow from (23). Two integrators run every scene. The energies, the work of heating and the work of
the point forces are integrated with the motion; their balance shows that force, energy and mass are consistent.
Reactions and loads must equal the rates of linear and angular momentum.
"""

from concurrent.futures import ProcessPoolExecutor

import numpy as np

from ..fixtures.fixture import nearest, settled
from ..motion import integrators
from . import equation23, scenes
from .cases import numbers
from .constraint import vector
from .nullspace import Structure, floats
from .scene import Scene, exact, piecewise

WORKERS = 2

SCENES = {
    "scissor-3-4": lambda: scenes.moving_scissor((3, 4)),
    "knee-2-1": lambda: scenes.moving_knee((2, 1)),
    "scissor-1-2": lambda: scenes.moving_scissor((1, 2)),
}

RTOL = 1e-9
# SciPy may guess a first step after a sample so long that numbers overflow before it is rejected.
FIRST_STEP = 1e-6

SAMPLES = 21
INTERVAL = 0.025

# Samples at which all nodal coordinates are stored: 0, 0.025, 0.05, 0.25 and 0.5 s.
NODAL = (0, 1, 2, 10, 20)

# For dU/d(dT) of each rod and the power of the forces, integrated with the motion; of order 1e-2 and 10.
ATOL_WORK = 1e-10

# Steps per interval: 5e-5 s for highest frequencies of 3.3e4 rad/s (thickness vibration), each split up to eight times.
STEPS = 500

# Largest distance between the two integrators (m) that may be written.
WORST = 1e-9

# Allowance for the rounding of another machine, in addition to the distance between the integrators: m, m/s, N and N m, J.
ROUNDING = {"position": 1e-11, "velocity": 1e-8, "force": 1e-4, "energy": 1e-9, "nodal": 1e-9}
# Likewise for the accelerations at the start, which no integrator enters: of the largest.
ROUNDING_AT_ONCE = 1e-11


def ends():
    """Times of the samples, which are the ends of the integrators' intervals."""
    return [k * INTERVAL for k in range(SAMPLES)]


def demand_kinks_at_samples(scene):
    """Asserts that histories have corners only where the integrators stop."""
    histories = [rod.history for rod in scene.rods] + [history for *_, history in scene.forces]
    step = exact(INTERVAL)
    assert all((t / step).q == 1 for history in histories for t, _ in history)


def demand_exact_terms(scene, structure):
    """Asserts mass, forces, accelerations and multipliers against the exact terms of (23) in a heated state."""
    t, n = exact(0.15), scene.size
    disturbed = [a + b for a, b in zip(scene.straight(), numbers(1, n, 8, 1024))]
    terms = equation23.of_scene(scene, t, disturbed, [exact(0)] * n, [])
    at = (nearest(t), np.array(floats(disturbed)))
    demand_close(structure.mass, terms.m.tolist())
    demand_close(structure.elastic_force(*at), terms.Q_e)
    demand_close(structure.applied_force(at[0]), terms.f)
    solution = equation23.of_scene(scene, t, scene.straight(), [exact(0)] * n, []).solution()
    acceleration = structure.B @ structure.acceleration(at[0], np.zeros(structure.B.shape[1]))
    demand_close(acceleration, solution[0])
    demand_close(structure.multipliers(at[0], structure.q_0, acceleration), solution[1])


def demand_close(value, term):
    """Asserts agreement relative to the largest entry."""
    assert abs(value - floats(term)).max() < 1e-11 * abs(value).max()


def prepare(name):
    """Scene and structure of a run."""
    scene = Scene(SCENES[name]())
    structure = Structure(scene)
    demand_kinks_at_samples(scene)
    demand_exact_terms(scene, structure)
    return scene, structure


def stored_samples(name):
    """One run by DOP853, with the work of heating and of the point forces."""
    scene, structure = prepare(name)
    n, rods = structure.B.shape[1], len(scene.rods)

    def rate(t, state):
        z, v = state[:n], state[n:2 * n]
        return np.concatenate([v, structure.rates(t, z, v)])

    atol = np.repeat([*integrators.tolerances(RTOL), ATOL_WORK], [n, n, rods + 1])
    start = np.zeros(2 * n + rods + 1)
    states = np.array(integrators.dop853(rate, start, RTOL, atol, ends(), FIRST_STEP))
    found = samples(structure, states[:, :n], states[:, n:2 * n])
    # dT is linear in an interval: the work of heating is the change of dT times the mean of dU/d(dT).
    dT = np.array([[piecewise(history, t) for history in structure.histories] for t in ends()])
    heating = (np.diff(dT, axis=0) * np.diff(states[:, 2 * n:-1], axis=0)).sum(1) / INTERVAL
    return found, states[:, -1] + np.append(0.0, np.cumsum(heating))


def second_samples(name):
    """One run by extrapolated Verlet steps, without the work."""
    _, structure = prepare(name)
    start = np.zeros(structure.B.shape[1])
    states = integrators.extrapolated_verlet(structure.acceleration, start, ends(), STEPS)
    return samples(structure, *(np.array(part) for part in zip(*states)))


def samples(structure, z, v):
    """All stored values except the work, as nested tables of arrays with one entry per sample."""
    at_times = []
    for t, *free in zip(ends(), z, v):
        acceleration = structure.B @ structure.acceleration(t, free[0])
        q, rate = structure.q_0 + structure.B @ free[0], structure.B @ free[1]
        multipliers = structure.multipliers(t, q, acceleration)
        reactions, moments, pins = structure.constraint_forces(q, multipliers)
        demand_momentum(structure, t, q, acceleration, reactions, moments)
        at_times.append({
            "nodal": q,
            "acceleration": acceleration,
            "position": structure.at_points(q),
            "velocity": structure.at_points(rate),
            "force": {"reaction": reactions, "moment": moments, "pin": pins},
            "energy": dict(zip(("kinetic", "strain", "potential"), structure.energies(t, q, rate))),
        })
    return transposed(at_times)


def transposed(tables):
    """A list of tables with equal keys as one table of arrays."""
    if isinstance(tables[0], dict):
        return {key: transposed([table[key] for table in tables]) for key in tables[0]}
    return np.array(tables)


def demand_momentum(structure, t, q, acceleration, reactions, moments):
    """Asserts the rates of linear and angular momentum against reactions, weight and point forces."""
    unbalanced = structure.mass @ acceleration - structure.applied_force(t)
    scale = max(1, abs(structure.elastic_force(t, q)).max())
    of_points = [
        vector(unbalanced, rod.first + k)
        for rod in structure.scene.rods for k in range(rod.vectors) if k % 5 in (0, 2)
    ]
    assert abs(sum(of_points) - sum(reactions.values())).max() < 1e-9 * scale, "linear momentum"
    by_forces = sum(cross(structure.at_points(q)[point], force) for point, force in reactions.items())
    moment = cross(q.reshape(-1, 2).T, unbalanced.reshape(-1, 2).T).sum()
    assert abs(moment - by_forces - sum(moments.values())) < 1e-9 * scale, "angular momentum"


def cross(a, b):
    """The product a x b in the plane."""
    return a[0] * b[1] - a[1] * b[0]


def distance(a, b):
    """Largest difference of two nested tables of arrays."""
    if isinstance(a, dict):
        return max((distance(a[key], b[key]) for key in a), default=0.0)
    return float(abs(a - b).max())


def lists(table):
    """Nested tables of arrays as nested tables of lists."""
    return {key: lists(value) for key, value in table.items()} if isinstance(table, dict) else table.tolist()


def run(name, values, work, second):
    """One entry of the fixture."""
    apart = {key: distance(values[key], second[key]) for key in ROUNDING}
    assert apart["position"] < WORST, f"{name}: the two integrators are {apart['position']} m apart"
    force = {f"{key}s": table for key, table in values["force"].items()}
    energy = values["energy"]
    total = sum(energy.values())
    return {
        "id": name,
        "scene": SCENES[name](),
        "method": integrators.described(RTOL),
        "t": [k / 40 for k in range(SAMPLES)],
        **lists({key: values[key] for key in ("position", "velocity")}),
        **lists(force),
        "energy": lists(energy | {"input": work}),
        "error_estimate": apart | {
            "how": f"largest difference over the samples to Verlet steps of {INTERVAL / STEPS:g} s, "
            f"extrapolated from 1 to {len(integrators.SPLITS)} splits (order {2 * len(integrators.SPLITS)})"},
        "energy_drift": float(abs(total - total[0] - work).max()),
        "initial_acceleration": values["acceleration"][0].tolist(),
        "nodal": {"t": [k / 40 for k in NODAL], "q": values["nodal"][list(NODAL)].tolist()},
    }


def generate():
    """All runs, in the order of their duration, the longest first."""
    with ProcessPoolExecutor(WORKERS) as pool:
        first = {name: pool.submit(stored_samples, name) for name in SCENES}
        second = {name: pool.submit(second_samples, name) for name in SCENES}
        return [run(name, *first[name].result(), second[name].result()) for name in SCENES]


def settled_runs(stored, fresh):
    """The stored document with its integrated numbers replaced by the fresh ones where they agree."""
    runs = stored.get("trajectories")
    if type(runs) is not list or len(runs) != len(fresh["trajectories"]):
        return stored
    return stored | {"trajectories": [settled_run(*pair) for pair in zip(runs, fresh["trajectories"])]}


def settled_run(stored, fresh):
    """A stored run with its integrated numbers replaced by the fresh ones where they agree."""
    estimate = fresh["error_estimate"]
    allowed = {name: estimate[name] + ROUNDING[name] for name in ROUNDING if name in estimate}
    tolerances = {
        "position": allowed["position"],
        "velocity": allowed["velocity"],
        "reactions": allowed["force"],
        "moments": allowed["force"],
        "pins": allowed["force"],
        "energy": allowed["energy"],
        "energy_drift": allowed["energy"],
        "error_estimate": allowed,
    }
    if "nodal" in allowed:
        largest = max(map(abs, fresh["initial_acceleration"]))
        tolerances |= {"initial_acceleration": ROUNDING_AT_ONCE * largest, "nodal": allowed["nodal"]}
    return settled(stored, fresh, tolerances)
