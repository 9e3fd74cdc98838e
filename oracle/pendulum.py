"""The pendulum of Table 1 from its strain energy alone, integrated far beyond engineering accuracy.

The position field is the polynomial (A.1) with the nodal conditions (A.2), element by element. The strain
energy is that of St Venant and Kirchhoff, with the thermal strain taken off the Green-Lagrange strain. From
these two follow

    kinetic energy    1/2 int rho |r'|^2 dV          -> M, exactly (polynomials),
    strain energy     int W(J) dV, J = dr/d(x, y)    -> Q_i = int dW/dJ : dJ/dq_i dV, dW/dJ derived by sympy,
    potential energy  -int rho g . r dV              -> the weight, exactly,

and M q'' = weight - Q(q). The rod lies along x at first, straight and unstretched, so J needs no initial
gradient. None of (9)-(22) is used.

Two integrators of different families run every case: DOP853 (Runge-Kutta, error control), whose numbers are
stored, and extrapolated Verlet steps (fixed step, order 16). Their distance is the stated error. The energies
show in addition that force, energy and mass belong together; they would not show a trajectory to be accurate.
"""

import platform
from concurrent.futures import ProcessPoolExecutor
from math import sqrt

import mpmath
import numpy as np
import scipy
import sympy

from . import fixture, integrate, rigid
from .beam import HEATED_DIRECTIONS, Beam, by_components, stress_and_energy
from .fixture import settled

FILE = "pendulum.json"
WORKERS = 2

TABLE_1 = {
    "L": 1.0, "h": 0.02, "w": 0.02,
    "rho": 7750.0, "E": 2e8, "nu": 0.0, "alpha": 2.85e-5,
    "dT": 200.0, "g": 9.8,
}

# Model, start, elements.
CASES = [("none", None, n) for n in (1, 2, 4)] + [
    (model, start, n) for model in ("1d", "2d") for start in ("sudden", "relaxed") for n in (2, 4)
]

RTOL = 1e-11

INTERVALS = 10
INTERVAL = 0.05

ENDS = [k * INTERVAL for k in range(INTERVALS + 1)]

# Steps of 5e-5 s, against a highest frequency of 2.8e4 rad/s (thickness vibration), split up to eight times.
STEPS = 1000

# An oracle worse than this (m) is not written.
WORST = 1e-10

# What another machine's rounding may add to the distance between two integrators: m, m/s, J.
ROUNDING = {"position": 1e-12, "velocity": 5e-10, "energy": 1e-9}


class Pendulum:
    """The hinged rod of n elements. Coordinates q: the nodal vectors in turn, but for the hinge's position.

    `C_T` holds the squared stress-free stretches along and across: two numbers, or two arrays for several
    rods side by side, whose coordinates are then the columns of q.
    """

    def __init__(self, elements, C_T, parameters=TABLE_1):
        self.elements, self.C_T, self.parameters = elements, C_T, parameters
        self.mu = parameters["E"] / (2 * (1 + parameters["nu"]))
        self.stress, self.energy_density, _ = stress_and_energy(parameters["nu"])
        rod = Beam(elements, *(sympy.Rational(str(parameters[name])) for name in ("L", "h", "w", "rho")))
        # The hinge holds the first vector, r(0), at the origin. Both components of r obey the same matrices.
        self.mass = np.kron(rod.mass[1:, 1:], np.eye(2))
        self.weight = np.kron(rod.weight[1:], [0.0, -parameters["g"]])
        self.volumes = rod.volumes
        self.gradient = by_components(rod.gradient[:, :, 1:])
        self.shape = (4, len(self.volumes), *np.shape(C_T)[1:])  # J11, J12, J21, J22 at all Gauss points
        inverse = scipy.linalg.cho_factor(self.mass)
        self.stress_to_acceleration = -scipy.linalg.cho_solve(
            inverse, self.gradient.T * np.tile(self.mu * self.volumes, 4))
        free_fall = scipy.linalg.cho_solve(inverse, self.weight)
        self.free_fall = free_fall.reshape(-1, *[1] * (len(self.shape) - 2))  # one for all rods

    def straight(self, along, across):
        """The straight rod along x, stretched along and across."""
        length = self.parameters["L"] / self.elements
        vectors = np.empty((5 * self.elements + 2, 2))
        for k in range(self.elements):
            vectors[5 * k:5 * k + 7] = [
                (k * length, 0), (0, 1),
                ((k + 0.5) * length, 0), (1, 0), (0, 1),
                ((k + 1) * length, 0), (0, 1),
            ]
        return (vectors * (along, across))[1:].ravel()

    def acceleration(self, _, q):
        """q'' = M^-1 (weight - Q(q)), at any time."""
        J = (self.gradient @ q).reshape(self.shape)
        return self.stress_to_acceleration @ np.concatenate(self.stress(*J, *self.C_T)) + self.free_fall

    def energies(self, q, v):
        """Kinetic, strain and potential energy; the potential is zero at the hinge's height."""
        J = (self.gradient @ q).reshape(self.shape)
        strain = self.mu * self.volumes @ self.energy_density(*J, *self.C_T)
        return np.array([(v * (self.mass @ v)).sum(0) / 2, strain, -self.weight @ q])


def prepare(case):
    """The rod of a case, and its coordinates at the start: relaxed means E = E_T, hence no stress."""
    model, start, elements = case
    C_T = [1 + 2 * heated * TABLE_1["alpha"] * TABLE_1["dT"] for heated in HEATED_DIRECTIONS[model]]
    rod = Pendulum(elements, C_T)
    return rod, rod.straight(*(sqrt(c) if start == "relaxed" else 1.0 for c in C_T))


def samples(rod, states):
    """Tip, its velocity, and the energies at each sample; r and r_y of the tip are the last two vectors."""
    q, v = (np.array(part)[:, -4:-2] for part in zip(*states))
    return {"position": q, "velocity": v, "energy": np.array([rod.energies(*state) for state in states])}


def stored_samples(case):
    """One case by DOP853."""
    rod, q = prepare(case)
    n = q.size

    def rate(t, state):
        return np.concatenate([state[n:], rod.acceleration(t, state[:n])])

    atol = np.repeat(integrate.tolerances(RTOL), n)
    states = integrate.dop853(rate, np.concatenate([q, np.zeros(n)]), RTOL, atol, ENDS)
    return samples(rod, [np.split(state, 2) for state in states])


def second_samples(cases):
    """Cases with equal numbers of elements by extrapolated Verlet steps, in a last index.

    With a fixed step they do not influence one another, so they run side by side in one array.
    """
    rods, starts = zip(*map(prepare, cases))
    together = Pendulum(rods[0].elements, np.transpose([rod.C_T for rod in rods]))
    start = np.transpose(starts)
    return samples(together, integrate.extrapolated_verlet(together.acceleration, start, ENDS, STEPS))


def run(case, values, second):
    """One entry of the fixture."""
    model, start, elements = case
    total = values["energy"].sum(1)
    distance = {name: float(abs(values[name] - second[name]).max()) for name in values}
    assert distance["position"] < WORST, f"{case}: the two integrators are {distance['position']} m apart"
    return {
        "id": f"{'flexible' if model == 'none' else f'{model}-{start}'}-{elements}",
        "model": model,
        "start": start,
        "elements": elements,
        "method": integrate.described(RTOL),
        "t": [k / 20 for k in range(INTERVALS + 1)],
        "tip": values["position"].tolist(),
        "tip_velocity": values["velocity"].tolist(),
        "energy": dict(zip(("kinetic", "strain", "potential"), values["energy"].T.tolist())),
        "error_estimate": distance | {
            "how": f"largest difference over the samples to Verlet steps of {INTERVAL / STEPS:g} s, "
            f"extrapolated from 1 to {len(integrate.SPLITS)} splits (order {2 * len(integrate.SPLITS)})"},
        "energy_drift": float(abs(total - total[0]).max()),
    }


def generate():
    """The fixture: the elastic pendulum in every case, and the rigid one in closed form."""
    with ProcessPoolExecutor(WORKERS) as pool:
        # The sudden 2d starts excite the thickness vibration and take longest.
        longest_first = sorted(CASES, key=lambda case: ("2d", "sudden") != case[:2])
        first = {case: pool.submit(stored_samples, case) for case in longest_first}
        alike = [[case for case in CASES if case[2] == elements] for elements in (1, 2, 4)]
        second = [pool.submit(second_samples, cases) for cases in alike]
        rigid_run = rigid.generate(TABLE_1["L"], TABLE_1["h"], TABLE_1["g"])
        runs = {}
        for cases, future in zip(alike, second):
            both = future.result()
            for k, case in enumerate(cases):
                its_own = {name: values[..., k] for name, values in both.items()}
                runs[case] = run(case, first[case].result(), its_own)
    return {
        "schema": "ancf-pendulum/1",
        "title": "The pendulum of Table 1 with 1, 2 and 4 elements, elastic and heated; and the rigid "
        "pendulum",
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
            "rod": "elements of equal length with the vectors r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k (4); "
            "neighbours share r and r_y at their common node",
            "hinge": "r of the left end's axis point is held at the origin; all slopes are free",
            "tip": "the axis point at x = L; tip_velocity is its velocity",
            "model": "thermal strain alpha dT times I for 2d, times t t^T with t the initial axis for 1d, "
            "zero for none",
            "start": "at rest, horizontal. sudden: unstretched, dT acts from t = 0. relaxed: at the "
            "stress-free stretch sqrt(1 + 2 alpha dT) in the heated directions. null: no heat",
            "energy": "kinetic; strain, as the integral of C_ijkl (E - E_T)_ij (E - E_T)_kl / 2; potential, "
            "zero at the hinge's height. Their sum is constant after t = 0",
            "error_estimate": "largest difference over the samples and components: position m, velocity m/s, "
            "energy J",
            "energy_drift": "largest change of the total energy, J; a kept energy is no evidence of accuracy",
            "edits": "never by hand: the command under generator writes this file, and with --check compares "
            "it",
        },
        "parameters": TABLE_1,
        "runs": [runs[case] for case in CASES],
        "rigid": rigid_run,
    }


def differences(stored, fresh):
    """Every difference but the tools' versions and what rounding explains.

    An integrated number may move by its error estimate, as derived now, and ROUNDING; so may the estimates.
    """
    tools = {"python", "numpy", "scipy", "sympy", "mpmath"}
    kept = {tool: version for tool, version in stored.get("generator", {}).items() if tool in tools}
    fresh = fresh | {"generator": fresh["generator"] | kept}
    return fixture.differences(settled_runs(stored, fresh), fresh)


def settled_runs(stored, fresh):
    """The stored document, its integrated numbers replaced by the fresh ones where they agree."""
    runs = stored.get("runs")
    if type(runs) is not list or len(runs) != len(fresh["runs"]):
        return stored
    return stored | {"runs": [settled_run(*pair) for pair in zip(runs, fresh["runs"])]}


def settled_run(stored, fresh):
    """The same for one run."""
    allowed = {name: fresh["error_estimate"][name] + ROUNDING[name] for name in ROUNDING}
    tolerances = {
        "tip": allowed["position"],
        "tip_velocity": allowed["velocity"],
        "energy": allowed["energy"],
        "energy_drift": allowed["energy"],
        "error_estimate": allowed,
    }
    return settled(stored, fresh, tolerances)
