"""`fixtures/pendulum.json`: the pendulum of Table 1 from its strain energy alone, far beyond engineering accuracy.

The position field is the polynomial (A.1) with the nodal conditions (A.2) in each element. The strain energy is that of
St Venant and Kirchhoff, with the thermal strain subtracted from the Green-Lagrange strain. From these two follow

    kinetic energy    1/2 int rho |r'|^2 dV          -> M, exactly (polynomials),
    strain energy     int W(J) dV, J = dr/d(x, y)    -> Q_i = int dW/dJ : dJ/dq_i dV, dW/dJ derived by sympy,
    potential energy  -int rho g . r dV              -> the weight, exactly,

and M q'' = weight - Q(q). The rod is at first straight and unstretched along x, so that J needs no initial gradient.
None of (9)-(22) is used. The Euler-Bernoulli element of `cable.element` is treated likewise, from its own field and
energy. `shear` adds the effect of a shear correction factor.

Two integrators of different families run every case: DOP853 (Runge-Kutta, error control), whose numbers are stored,
and extrapolated Verlet steps (fixed step, order 16). Their distance is the stated error. The energy balance shows that
force, energy and mass are consistent; it does not show that a trajectory is accurate.
"""

import platform
from concurrent.futures import ProcessPoolExecutor

import mpmath
import numpy as np
import scipy
import sympy

from ..fixtures import fixture
from ..fixtures.fixture import settled
from . import integrators, rigid_pendulum, shear
from .axis import Axis
from .beam import HEATED_DIRECTIONS, Beam
from .hinged_rod import TABLE_1, Cable, Plane, sizes

FILE = "pendulum.json"
WORKERS = 2

# Samples at which all nodal coordinates are stored.
NODAL = (0, 1, 5, 10)

RODS = {"ancf": Plane, "euler-bernoulli": Cable}

# Element, model, start, number of elements. The models 1d and 2d are equal for the Euler-Bernoulli element, which has no
# section to heat across.
CASES = [
    (element, model, start, n)
    for element, heated in (("ancf", ("1d", "2d", "transverse")), ("euler-bernoulli", ("1d",)))
    for model, starts, numbers in (
        ("none", (None,), (1, 2, 4)), *((model, ("sudden", "relaxed"), (2, 4)) for model in heated))
    for start in starts for n in numbers
]

RTOL = 1e-11

INTERVALS = 10
INTERVAL = 0.05

ENDS = [k * INTERVAL for k in range(INTERVALS + 1)]

# Steps per interval, each split up to eight times: 5e-5 s for a highest frequency of 2.8e4 rad/s (thickness vibration),
# 2e-4 s for 6e3 rad/s (axial vibration).
STEPS = {"ancf": 1000, "euler-bernoulli": 250}

# Largest distance between the two integrators (m) that may be written.
WORST = 1e-10

# Allowance for the rounding of another machine, in addition to the distance between the integrators: m, m/s, J.
ROUNDING = {"position": 1e-12, "velocity": 5e-10, "energy": 1e-9}
# Likewise for what no integrator enters: kg and its moments; coordinates, whose slopes the tip's position does not bound; their
# initial accelerations, m/s^2 and 1/s^2.
ROUNDING_AT_ONCE = {"mass": 1e-14, "nodal": 1e-9, "acceleration": 1e-6}


def prepare(case):
    """The rod of a case and its coordinates at the start; a relaxed start is free of stress."""
    element, model, start, elements = case
    rod = RODS[element](elements, RODS[element].heat_of(model))
    return rod, rod.straight(relaxed=start == "relaxed")


def samples(rod, states):
    """Tip, its velocity, and the energies at each sample; r of the tip is the last vector but one."""
    q, v = (np.array(part)[:, -4:-2] for part in zip(*states))
    return {"position": q, "velocity": v, "energy": np.array([rod.energies(*state) for state in states])}


def stored_samples(case):
    """One case by DOP853."""
    rod, q = prepare(case)
    n = q.size

    def rate(t, state):
        return np.concatenate([state[n:], rod.acceleration(t, state[:n])])

    atol = np.repeat(integrators.tolerances(RTOL), n)
    states = integrators.dop853(rate, np.concatenate([q, np.zeros(n)]), RTOL, atol, ENDS)
    return samples(rod, [np.split(state, 2) for state in states]), initial(rod, q), [states[k][:n] for k in NODAL]


def initial(rod, q):
    """Accelerations at the start."""
    return rod.acceleration(0.0, q)


def with_hinge(vector):
    """Coordinates with those of the hinge, which do not move."""
    return [0.0, 0.0, *vector.tolist()]


def masses():
    """Mass matrix of each rod for one component of its nodal vectors, with the hinge, by element and number of elements."""
    beams = {"ancf": Beam, "euler-bernoulli": Axis}
    return {f"{element}-{n}": beams[element](n, *sizes(TABLE_1)).mass.tolist() for element in RODS for n in (1, 2, 4)}


def second_samples(cases):
    """Cases with the same element and mesh by extrapolated Verlet steps; the last index is the case.

    The cases run together in one array. With a fixed step they do not influence one another.
    """
    rods, starts = zip(*map(prepare, cases))
    together = type(rods[0])(rods[0].elements, np.transpose([rod.heat for rod in rods]))
    start, steps = np.transpose(starts), STEPS[cases[0][0]]
    return samples(together, integrators.extrapolated_verlet(together.acceleration, start, ENDS, steps))


def run(case, stored, second):
    """One entry of the fixture."""
    element, model, start, elements = case
    values, acceleration, nodal = stored
    total = values["energy"].sum(1)
    distance = {name: float(abs(values[name] - second[name]).max()) for name in values}
    assert distance["position"] < WORST, f"{case}: the two integrators are {distance['position']} m apart"
    parts = ("flexible" if model == "none" else model, "eb" if element != "ancf" else None, start, str(elements))
    return {
        "id": "-".join(part for part in parts if part),
        "element": element,
        "model": model,
        "start": start,
        "elements": elements,
        "method": integrators.described(RTOL),
        "t": [k / 20 for k in range(INTERVALS + 1)],
        "tip": values["position"].tolist(),
        "tip_velocity": values["velocity"].tolist(),
        "energy": dict(zip(("kinetic", "strain", "potential"), values["energy"].T.tolist())),
        "error_estimate": distance | {
            "how": f"largest difference over the samples to Verlet steps of {INTERVAL / STEPS[element]:g} s, "
            f"extrapolated from 1 to {len(integrators.SPLITS)} splits (order {2 * len(integrators.SPLITS)})"},
        "energy_drift": float(abs(total - total[0]).max()),
        "initial_acceleration": with_hinge(acceleration),
        "nodal": {"t": [k / 20 for k in NODAL], "q": [with_hinge(q) for q in nodal]},
    }


def generate():
    """The fixture: elastic pendulum in every case, rigid pendulum, effect of a shear correction."""
    with ProcessPoolExecutor(WORKERS) as pool:
        # Sudden heat across excites the thickness vibration: these cases take longest.
        longest_first = sorted(CASES, key=lambda case: (HEATED_DIRECTIONS[case[1]][1], case[2]) != (1, "sudden"))
        first = {case: pool.submit(stored_samples, case) for case in longest_first}
        alike = [
            [case for case in CASES if (case[0], case[3]) == (element, elements)]
            for element in RODS for elements in (1, 2, 4)
        ]
        second = [pool.submit(second_samples, cases) for cases in alike]
        shifts = [pool.submit(shear.shift, *run) for run in shear.RUNS]
        rigid_run = rigid_pendulum.generate(TABLE_1["L"], TABLE_1["h"], TABLE_1["g"])
        runs = {}
        for cases, future in zip(alike, second):
            both = future.result()
            for k, case in enumerate(cases):
                its_own = {name: values[..., k] for name, values in both.items()}
                runs[case] = run(case, first[case].result(), its_own)
        shear_entry = shear.entry(*(future.result() for future in shifts))
    return {
        "schema": "ancf-pendulum/1",
        "title": "The pendulum of Table 1 with 1, 2 and 4 elements, elastic and heated; the rigid "
        "pendulum; and what a shear correction would change",
        "source": "Peng, Wang, Li, Zhi, Li 2018, doi 10.1155/2018/1752815, Table 1",
        "generator": {
            "command": "python -m oracle pendulum",
            "python": ".".join(platform.python_version_tuple()[:2]),
            "numpy": np.__version__,
            "scipy": scipy.__version__,
            "sympy": sympy.__version__,
            "mpmath": mpmath.__version__,
        },
        "conventions": {
            "units": "SI: m, s, kg, K, J",
            "axes": "x along the rod at first, y upwards; gravity is (0, -g)",
            "rod": "elements of equal length. ancf: with the vectors r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k (4); "
            "neighbours share r and r_y at their common node. euler-bernoulli: that of cable.json, with r_i, r_x_i, "
            "r_k, r_x_k; neighbours share r and r_x",
            "hinge": "r of the left end's axis point is held at the origin; all slopes are free",
            "tip": "the axis point at x = L; tip_velocity is its velocity",
            "model": "thermal strain alpha dT times I for 2d, times t t^T with t the initial axis for 1d, "
            "times n n^T with n across it for transverse, zero for none; for euler-bernoulli alpha dT along the axis",
            "start": "at rest, horizontal. sudden: unstretched, dT acts from t = 0. relaxed: at the "
            "stress-free stretch, sqrt(1 + 2 alpha dT) in the heated directions, for euler-bernoulli 1 + alpha dT "
            "along. null: no heat",
            "energy": "kinetic; strain, as the integral of C_ijkl (E - E_T)_ij (E - E_T)_kl / 2, for euler-bernoulli "
            "the Gauss sums of cable.json; potential, zero at the hinge's height. Their sum is constant after t = 0",
            "error_estimate": "largest difference over the samples and components: position m, velocity m/s, "
            "energy J",
            "energy_drift": "largest change of the total energy, J; a kept energy is no evidence of accuracy",
            "q": "nodal.q and initial_acceleration: the vectors of `rod` element by element, those of a shared node once, "
            "the hinge's r first; each vector x before y. masses: mass matrix by element and number of elements for one "
            "component of these vectors; the other component has the same, and nothing couples them",
            "edits": "never by hand: the command under generator writes this file, and with --check compares "
            "it",
        },
        "parameters": TABLE_1,
        "runs": [runs[case] for case in CASES],
        "masses": masses(),
        "rigid": rigid_run,
        "shear": shear_entry,
    }


def differences(stored, fresh):
    """Differences, except in the versions of the tools and in digits that rounding explains.

    An integrated number, or an error estimate, may differ by the error estimate derived now plus ROUNDING.
    """
    tools = {"python", "numpy", "scipy", "sympy", "mpmath"}
    kept = {tool: version for tool, version in stored.get("generator", {}).items() if tool in tools}
    fresh = fresh | {"generator": fresh["generator"] | kept}
    return fixture.differences(settled_document(stored, fresh), fresh)


def keep(stored, fresh):
    """The fresh document with the stored digits wherever rounding explains the difference: no value changes unless it must."""
    return settled_document(fresh, stored)


def settled_document(stored, fresh):
    """The stored document with its numbers replaced by the fresh ones where rounding explains the difference."""
    stored = settled_runs(stored, fresh)
    if type(stored.get("shear")) is dict:
        stored = stored | {"shear": shear.settled_entry(stored["shear"], fresh["shear"])}
    return stored | {key: settled(stored[key], fresh[key], ROUNDING_AT_ONCE["mass"]) for key in ("masses",) if key in stored and key in fresh}


def settled_runs(stored, fresh):
    """The stored document with its integrated numbers replaced by the fresh ones of the same run where they agree."""
    runs = stored.get("runs")
    if type(runs) is not list:
        return stored
    fresh_runs = {run["id"]: run for run in fresh["runs"]}

    def settled_or_kept(run):
        same = fresh_runs.get(run.get("id")) if type(run) is dict else None
        return settled_run(run, same) if same else run

    return stored | {"runs": [settled_or_kept(run) for run in runs]}


def settled_run(stored, fresh):
    """A stored run with its integrated numbers replaced by the fresh ones where they agree."""
    allowed = {name: fresh["error_estimate"][name] + ROUNDING[name] for name in ROUNDING}
    tolerances = {
        "tip": allowed["position"],
        "tip_velocity": allowed["velocity"],
        "energy": allowed["energy"],
        "energy_drift": allowed["energy"],
        "error_estimate": allowed,
        "initial_acceleration": ROUNDING_AT_ONCE["acceleration"],
        "nodal": ROUNDING_AT_ONCE["nodal"],
    }
    return settled(stored, fresh, tolerances)
