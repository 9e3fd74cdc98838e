"""The rigid pendulum of Table 1 in closed form, the limit of the elastic rod for infinite stiffness.

A uniform bar of length L and height h hangs on a hinge at the end of its axis. Its centre of mass is at L/2
and its moment of inertia about the hinge is m (L^2/3 + h^2/12), so the angle phi from the downward vertical
obeys, whatever its mass m,

    phi'' = -omega^2 sin phi,   omega^2 = g (L/2) / (L^2/3 + h^2/12).

Released at rest from phi_0, it moves by a Jacobian elliptic function:

    sin(phi/2) = k cd(omega t | k^2),   k = sin(phi_0/2),   phi_0 = pi/2 for the horizontal start.
"""

from mpmath import mp, mpf

DIGITS = 30
SAMPLES_PER_SECOND = 100
DURATION = 2

HOW = (
    "sin(phi/2) = k cd(omega t | k^2), k = sin(pi/4), phi from the downward vertical; "
    f"mpmath with {DIGITS} digits, rounded to the nearest double; agrees with a Taylor-series integration "
    "of the equation of motion"
)


def generate(L, h, g):
    """The tip at 0, 0.01 ... 2 s. Closed form and integrated equation of motion must agree."""
    with mp.workdps(DIGITS):
        L, h, g = (mpf(str(value)) for value in (L, h, g))
        omega_squared = g * (L / 2) / (L**2 / 3 + h**2 / 12)
        times = [mpf(k) / SAMPLES_PER_SECOND for k in range(DURATION * SAMPLES_PER_SECOND + 1)]
        closed_form = [_angle(t, omega_squared) for t in times]
        integrated = _integrated_angles(times, omega_squared)
        disagreement = max(abs(a - b) for a, b in zip(closed_form, integrated))
        assert disagreement < mpf(10) ** (5 - DIGITS), f"closed form and integration differ by {disagreement}"
        return {
            "t": [float(t) for t in times],
            "tip": [[_rounded(L * mp.sin(phi)), _rounded(-L * mp.cos(phi))] for phi in closed_form],
            "how": HOW,
            "error_estimate": {
                "position": 2.0**-53 * float(L),
                "how": "rounding to the nearest double; closed form and integration agree to "
                f"10^{5 - DIGITS} rad, asserted",
            },
        }


def _angle(t, omega_squared):
    """phi(t) by the elliptic function."""
    k = mp.sin(mp.pi / 4)
    return 2 * mp.asin(k * mp.ellipfun("cd", mp.sqrt(omega_squared) * t, m=k**2))


def _integrated_angles(times, omega_squared):
    """phi at the given times from its equation of motion, by mpmath's Taylor-series integrator."""
    solution = mp.odefun(lambda t, y: [y[1], -omega_squared * mp.sin(y[0])], 0, [mp.pi / 2, mpf(0)])
    return [solution(t)[0] for t in times]


def _rounded(value):
    """The nearest double; a value that DIGITS cannot distinguish from zero is zero."""
    return float(mp.chop(value, mpf(10) ** (5 - DIGITS)))
