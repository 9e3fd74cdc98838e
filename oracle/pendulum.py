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

import os
import platform
from concurrent.futures import ProcessPoolExecutor
from math import prod, sqrt

# The matrices are small: threads would cost more than they bring. Has to be said before numpy is loaded.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import mpmath
import numpy as np
import scipy
import sympy

from . import field, fixture, rigid

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
# Along x, which is the rod's initial axis, and across.
HEATED_DIRECTIONS = {"none": (0, 0), "1d": (1, 0), "2d": (1, 1)}

INTERVALS = 10
INTERVAL = 0.05

# The integrand of Q has degree 8 in x and 4 in y: J has degree 2 in x and 1 in y, dW/dJ is cubic in J.
GAUSS_POINTS = (5, 3)

RTOL = 1e-11
# Positions (the rod is 1 m long) and slopes are of order 1. What moves the tip is no faster than some
# 100 rad/s, which makes 1e-11 the velocity that belongs to 1e-13 of a coordinate.
ATOL_COORDINATE = 1e-13
ATOL_VELOCITY = 1e-11

# Steps of 5e-5 s, against a highest frequency of 2.8e4 rad/s (thickness vibration), split up to eight times.
SPLITS = range(1, 9)
STEPS = 1000

# An oracle worse than this (m) is not written.
WORST = 1e-10

# What another machine's rounding may add to the distance between two integrators: m, m/s, J.
ROUNDING = {"position": 1e-12, "velocity": 5e-10, "energy": 1e-9}


def stress_and_energy(nu):
    """First Piola-Kirchhoff stress dW/dJ and energy density W, both over mu, as functions of J and C_T.

    W = 1/2 C_ijkl E_ij E_kl with C_ijkl = lambda d_ij d_kl + mu (d_ik d_jl + d_il d_jk) contracts to
    lambda/2 (tr E)^2 + mu E:E. E = (J^T J - I)/2 - E_T is (J^T J - C_T)/2 with C_T = I + 2 E_T, the square of
    the stress-free stretch, diagonal here. Arguments: J11, J12, J21, J22, then C_T along and across.
    """
    J = sympy.Matrix(2, 2, sympy.symbols("J11 J12 J21 J22"))
    C_T = sympy.symbols("C_along C_across")
    nu = sympy.Rational(str(nu))
    E = (J.T * J - sympy.diag(*C_T)) / 2
    W = nu / (1 - 2 * nu) * E.trace() ** 2 + sum(entry**2 for entry in E)
    stress = [sympy.factor_terms(W.diff(entry)) for entry in J]
    return tuple(sympy.lambdify((*J, *C_T), result, "numpy", cse=True) for result in (stress, W))


class Rod:
    """The hinged rod of n elements. Coordinates q: the nodal vectors in turn, but for the hinge's position.

    `C_T` holds the squared stress-free stretches along and across: two numbers, or two arrays for several
    rods side by side, whose coordinates are then the columns of q.
    """

    def __init__(self, elements, C_T, parameters=TABLE_1):
        self.elements, self.C_T, self.parameters = elements, C_T, parameters
        self.mu = parameters["E"] / (2 * (1 + parameters["nu"]))
        self.stress, self.energy_density = stress_and_energy(parameters["nu"])
        mass, weight, gradient, volumes = self._element()
        points = len(volumes)
        vectors = 5 * elements + 2  # neighbours share r and r_y at their common node
        whole_mass, whole_weight = np.zeros((vectors, vectors)), np.zeros(vectors)
        whole_gradient = np.zeros((2, elements, points, vectors))
        for k in range(elements):
            own = slice(5 * k, 5 * k + 7)
            whole_mass[own, own] += mass
            whole_weight[own] += weight
            whole_gradient[:, k, :, own] = gradient
        # The hinge holds the first vector, r(0), at the origin. Both components of r obey the same matrices.
        self.mass = np.kron(whole_mass[1:, 1:], np.eye(2))
        self.weight = np.kron(whole_weight[1:], [0.0, -parameters["g"]])
        self.volumes = np.tile(volumes, elements)
        d_x, d_y = whole_gradient.reshape(2, elements * points, vectors)[:, :, 1:]
        self.gradient = np.vstack([np.kron(d, component) for component in np.eye(2) for d in (d_x, d_y)])
        self.shape = (4, elements * points, *np.shape(C_T)[1:])  # J11, J12, J21, J22 at all Gauss points
        inverse = scipy.linalg.cho_factor(self.mass)
        self.stress_to_acceleration = -scipy.linalg.cho_solve(
            inverse, self.gradient.T * np.tile(self.mu * self.volumes, 4))
        free_fall = scipy.linalg.cho_solve(inverse, self.weight)
        self.free_fall = free_fall.reshape(-1, *[1] * (len(self.shape) - 2))  # one for all rods

    def _element(self):
        """Of one element: mass matrix, integral of rho S, S_x and S_y at the Gauss points, their volumes."""
        L, h, w, rho = (sympy.Rational(str(self.parameters[name])) for name in ("L", "h", "w", "rho"))
        x, y, length = field.x, field.y, L / self.elements
        S = sympy.Matrix(field.shape_functions()).subs(field.l, length)

        def integral(f):
            """Over 0 <= x <= length, |y| <= h/2, term by term; odd powers of y vanish."""
            terms = [(c, i + 1, j + 1) for (i, j), c in sympy.Poly(f, x, y).terms() if j % 2 == 0]
            return w * sum(c * length**i / i * 2 * (h / 2)**j / j for c, i, j in terms)

        mass = np.array((rho * S * S.T).applyfunc(integral), float)
        weight = np.array((rho * S).applyfunc(integral), float)[:, 0]
        (a, weights_a), (b, weights_b) = map(np.polynomial.legendre.leggauss, GAUSS_POINTS)
        at = [(float(length) / 2 * (1 + i), float(h) / 2 * j) for i in a for j in b]
        derivatives = [sympy.lambdify((x, y), list(S.diff(direction))) for direction in (x, y)]
        gradient = np.array([[derivative(*point) for point in at] for derivative in derivatives], float)
        volumes = np.outer(weights_a, weights_b).ravel() * float(length * h * w) / 4
        return mass, weight, gradient, volumes

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

    def acceleration(self, q):
        """q'' = M^-1 (weight - Q(q))."""
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
    rod = Rod(elements, C_T)
    return rod, rod.straight(*(sqrt(c) if start == "relaxed" else 1.0 for c in C_T))


def dop853(rod, q):
    """Coordinates and velocities at the samples; every interval ends on a sample, so none is interpolated."""
    n = q.size
    tolerance = np.repeat([ATOL_COORDINATE, ATOL_VELOCITY], n)

    def rate(_, state):
        return np.concatenate([state[n:], rod.acceleration(state[:n])])

    states = [np.concatenate([q, np.zeros(n)])]
    for k in range(INTERVALS):
        interval = (k * INTERVAL, (k + 1) * INTERVAL)
        solution = scipy.integrate.solve_ivp(rate, interval, states[-1], "DOP853", rtol=RTOL, atol=tolerance)
        if not solution.success:
            raise ArithmeticError(f"DOP853 stopped at t = {solution.t[-1]} s: {solution.message}")
        states.append(solution.y[:, -1])
    return [np.split(state, 2) for state in states]


def extrapolated_verlet(rod, q):
    """The same: each step is taken whole, in 2, 3 ... 8 Verlet steps, and extrapolated to infinitely many.

    The Verlet rule is symmetric in time, so its error has even powers of the step only, and eight splits
    leave order 16.
    """
    weights = [prod(j**2 / (j**2 - i**2) for i in SPLITS if i != j) for j in SPLITS]
    v = np.zeros_like(q)
    states = [(q, v)]
    for _ in range(INTERVALS):
        for _ in range(STEPS):
            a = rod.acceleration(q)
            changes = [verlet(rod, q, v, a, INTERVAL / STEPS, j) for j in SPLITS]
            q = q + sum(weight * change for weight, (change, _) in zip(weights, changes))
            v = v + sum(weight * change for weight, (_, change) in zip(weights, changes))
        states.append((q, v))
    return states


def verlet(rod, q, v, a, duration, splits):
    """Changes of q and v by velocity Verlet; a is the acceleration at q. Changes round less than states."""
    step = duration / splits
    change_q, change_v = 0.0, 0.0
    for _ in range(splits):
        half = change_v + step / 2 * a
        change_q = change_q + step * (v + half)
        a = rod.acceleration(q + change_q)
        change_v = half + step / 2 * a
    return change_q, change_v


def samples(rod, states):
    """Tip, its velocity, and the energies at each sample; r and r_y of the tip are the last two vectors."""
    q, v = (np.array(part)[:, -4:-2] for part in zip(*states))
    return {"position": q, "velocity": v, "energy": np.array([rod.energies(*state) for state in states])}


def stored_samples(case):
    """One case by DOP853."""
    rod, q = prepare(case)
    return samples(rod, dop853(rod, q))


def second_samples(cases):
    """Cases with equal numbers of elements by extrapolated Verlet steps, in a last index.

    With a fixed step they do not influence one another, so they run side by side in one array.
    """
    rods, starts = zip(*map(prepare, cases))
    together = Rod(rods[0].elements, np.transpose([rod.C_T for rod in rods]))
    return samples(together, extrapolated_verlet(together, np.transpose(starts)))


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
        "method": f"DOP853, rtol {RTOL:g}, atol {ATOL_COORDINATE:g} (coordinates), "
        f"{ATOL_VELOCITY:g} (velocities)",
        "t": [k / 20 for k in range(INTERVALS + 1)],
        "tip": values["position"].tolist(),
        "tip_velocity": values["velocity"].tolist(),
        "energy": dict(zip(("kinetic", "strain", "potential"), values["energy"].T.tolist())),
        "error_estimate": distance | {
            "how": f"largest difference over the samples to Verlet steps of {INTERVAL / STEPS:g} s, "
            f"extrapolated from 1 to {len(SPLITS)} splits (order {2 * len(SPLITS)})"},
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


def settled(stored, fresh, tolerance):
    """The stored value, with numbers within the tolerance replaced; a table of tolerances goes by key."""
    if type(stored) is dict and type(fresh) is dict:
        by_key = tolerance if type(tolerance) is dict else dict.fromkeys(fresh, tolerance)
        shared = by_key.keys() & stored.keys() & fresh.keys()
        return stored | {key: settled(stored[key], fresh[key], by_key[key]) for key in shared}
    if type(stored) is list and type(fresh) is list and len(stored) == len(fresh):
        return [settled(*pair, tolerance) for pair in zip(stored, fresh)]
    close = type(stored) is float and type(fresh) is float and abs(stored - fresh) <= tolerance
    return fresh if close else stored
