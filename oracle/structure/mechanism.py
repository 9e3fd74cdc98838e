"""The deployable structure of n scissors with rigid rods: one coordinate, with its motion by quadrature.

a_k = ((k - 1) L cos theta, L sin theta) and b_k = ((k - 1) L cos theta, 0), k = 1 ... n + 1; the rods are
a_k - b_(k+1) and b_k - a_(k+1), pinned at their middles and at coinciding ends. b_1 is held at the origin,
a_1 slides on x = 0 and carries the force F in -y; there is no gravity. The kinetic energy M(theta) theta'^2/2 is the
work of the force since the start at rest at theta_0:

    M(theta) theta'^2/2 = F L (sin theta_0 - sin theta),

which gives the time as an integral over theta. The integrand is singular at the start, like 1/sqrt(theta_0 - theta),
and regular in u with theta = theta_0 - u^2. At theta = 0 all rods lie on one line and the motion could continue in more
than one way; samples end before that.
"""

from functools import cache

import sympy
from mpmath import mp, mpf

DIGITS = 24
SCISSORS = (1, 3)
DURATION = 3
SAMPLES_PER_SECOND = 10

# Table 2, the force of Section 4, and the assumed start, in degrees.
PARAMETERS = {"L": 2.0, "h": 0.02, "w": 0.02, "rho": 2750.0, "F": 50.0, "theta_0": 80.0}

L, h, m = sympy.symbols("L h m", positive=True)
theta, rate = sympy.symbols("theta rate")


def place(name, k):
    """The point a_k or b_k."""
    return sympy.Matrix([(k - 1) * L * sympy.cos(theta), L * sympy.sin(theta) if name == "a" else 0])


@cache
def inertia(n):
    """M(theta), from the velocities of the points of the rods.

    A rod's axis runs from one end to the other, s = 0 ... 1. Its mass is uniform over its length and its height h, like
    that of the elastic rod: h adds the rotary inertia m h^2/12.
    """
    s = sympy.symbols("s")
    energy = 0
    for k in range(1, n + 1):
        for start, end in (("a", "b"), ("b", "a")):
            axis = (1 - s) * place(start, k) + s * place(end, k + 1)
            assert sympy.simplify((axis.diff(s).T * axis.diff(s))[0] - L**2) == 0, "the rod must be rigid"
            velocity = axis.diff(theta) * rate
            energy += m / 2 * sympy.integrate(sympy.expand((velocity.T * velocity)[0]), (s, 0, 1))
            energy += m / 2 * h**2 / 12 * rate**2
    return sympy.simplify(energy.diff(rate, 2))


class Mechanism:
    """n scissors with the parameters of `PARAMETERS`."""

    def __init__(self, n):
        self.n = n
        size = {name: mpf(str(value)) for name, value in PARAMETERS.items()}
        self.length, self.force, self.start = size["L"], size["F"], mp.radians(size["theta_0"])
        numbers = {L: size["L"], h: size["h"], m: size["rho"] * size["L"] * size["h"] * size["w"]}
        M = inertia(n).subs({symbol: sympy.Float(number, DIGITS) for symbol, number in numbers.items()})
        self.M, self.M_slope = (sympy.lambdify(theta, f, "mpmath") for f in (M, M.diff(theta)))
        tip = place("a", n + 1).subs(L, sympy.Float(size["L"], DIGITS))
        self.tip, self.tip_slope = (sympy.lambdify(theta, list(f), "mpmath") for f in (tip, tip.diff(theta)))

    def drop(self, u):
        """(sin theta_0 - sin theta)/u^2, without cancellation."""
        return 2 * mp.cos(self.start - u**2 / 2) * mp.sin(u**2 / 2) / u**2 if u else mp.cos(self.start)

    def time_rate(self, u):
        """dt/du = 2 u sqrt(M/(2 F L (sin theta_0 - sin theta)))."""
        M = self.M(self.start - u**2)
        return 2 * mp.sqrt(M / (2 * self.force * self.length * self.drop(u)))

    def time(self, u, earlier=(0, 0)):
        """t at u, integrated from an earlier pair (u, t)."""
        return earlier[1] + mp.quad(self.time_rate, [earlier[0], u])

    def rate(self, angle):
        """theta' from the energy."""
        u = mp.sqrt(self.start - angle)
        return -u * mp.sqrt(2 * self.force * self.length * self.drop(u) / self.M(angle))

    def angles(self, times):
        """theta at the given times, by Newton's method for t(u), sample by sample."""
        pair, found = (mpf(0), mpf(0)), []
        for t in times:
            u = pair[0] + (t - pair[1]) / self.time_rate(pair[0])
            for _ in range(30):
                change = (t - self.time(u, pair)) / self.time_rate(u)
                u += change
                if abs(change) < mpf(10) ** (3 - DIGITS):
                    break
            else:
                raise ArithmeticError(f"Newton's method does not converge at t = {t} s")
            pair = (u, t)
            found.append(self.start - u**2)
        return found

    def integrated(self, times):
        """theta and theta' from Lagrange's equation, M theta'' + M' theta'^2/2 = -F L cos theta."""

        def slope(_, state):
            angle, rate = state
            drive = -self.force * self.length * mp.cos(angle)
            return [rate, (drive - self.M_slope(angle) * rate**2 / 2) / self.M(angle)]

        solution = mp.odefun(slope, 0, [self.start, mpf(0)])
        return [solution(t) for t in times]


def run(n):
    """One entry of the fixture."""
    mechanism = Mechanism(n)
    flat = mechanism.time(mp.sqrt(mechanism.start))
    count = min(DURATION * SAMPLES_PER_SECOND, int(flat * SAMPLES_PER_SECOND))
    times = [mpf(k) / SAMPLES_PER_SECOND for k in range(count + 1)]
    angles = mechanism.angles(times)
    rates = [mechanism.rate(angle) for angle in angles]
    second = mechanism.integrated(times + [flat])
    distance = max(abs(a - b) for a, (b, _) in zip(angles + [mpf(0)], second))
    distance_rate = max(abs(a - b) for a, (_, b) in zip(rates, second))
    assert max(distance, distance_rate) < mpf(10) ** (6 - DIGITS), (distance, distance_rate)
    return {
        "scissors": n,
        "t": [float(t) for t in times],
        "theta": [float(angle) for angle in angles],
        "theta_rate": [float(rate) for rate in rates],
        "tip": [[float(mp.chop(c)) for c in mechanism.tip(angle)] for angle in angles],
        "tip_velocity": [
            [float(mp.chop(c * rate)) for c in mechanism.tip_slope(angle)]
            for angle, rate in zip(angles, rates)
        ],
        "flat_at": float(flat),
        "error_estimate": {
            "theta": float(f"{float(distance):.0e}"),
            "theta_rate": float(f"{float(distance_rate):.0e}"),
        },
    }


def generate():
    """The rigid mechanism for each number of scissors, by quadrature and by its equation of motion."""
    with mp.workdps(DIGITS):
        runs = [run(n) for n in SCISSORS]
    return {
        "parameters": PARAMETERS,
        "how": "M theta'^2/2 = F L (sin theta_0 - sin theta), t by quadrature in u = sqrt(theta_0 - theta), "
        f"mpmath with {DIGITS} digits, rounded to the nearest double; Lagrange's equation by mpmath's Taylor "
        f"series agrees to 10^{6 - DIGITS} (rad, rad/s), asserted; error_estimate is their distance before "
        "rounding, and at flat_at that of theta from 0",
        "runs": runs,
    }
