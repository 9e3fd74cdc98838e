"""Two integrators of different families for q'' = acceleration(t, q).

Their distance is an error estimate that neither could give alone. Both stop at the given ends of intervals: no sample
is interpolated, and histories may have corners at these times only.
"""

from itertools import pairwise
from math import prod

import numpy as np
import scipy

SPLITS = range(1, 9)


def tolerances(rtol):
    """Absolute tolerances of coordinates and of velocities that belong to a relative tolerance.

    Positions (the rods are about 1 m long) and slopes are of order 1. Visible motions are slower than about 100 rad/s,
    so that an error of 1e-13 in a coordinate corresponds to 1e-11 in its velocity.
    """
    return rtol / 100, rtol


def described(rtol):
    """Description of DOP853 with its tolerances."""
    coordinate, velocity = tolerances(rtol)
    return f"DOP853, rtol {rtol:g}, atol {coordinate:g} (coordinates), {velocity:g} (velocities)"


def dop853(rate, state, rtol, atol, ends, first_step=None):
    """States of state' = rate(t, state) at the ends of the intervals, by Runge-Kutta with error control.

    `first_step` is the first step of each interval; without it SciPy guesses one.
    """
    states = [state]
    for interval in pairwise(ends):
        solution = scipy.integrate.solve_ivp(
            rate, interval, states[-1], "DOP853", rtol=rtol, atol=atol, first_step=first_step)
        if not solution.success:
            raise ArithmeticError(f"DOP853 stopped at t = {solution.t[-1]} s: {solution.message}")
        states.append(solution.y[:, -1])
    return states


def extrapolated_verlet(acceleration, q, ends, steps):
    """Pairs q, q' from rest, by extrapolation of each step from 1, 2 ... 8 Verlet steps.

    The Verlet rule is symmetric in time: its error has only even powers of the step, so that eight splits give order 16.
    All intervals have the same number of steps.
    """
    weights = [prod(j**2 / (j**2 - i**2) for i in SPLITS if i != j) for j in SPLITS]
    v = np.zeros_like(q)
    states = [(q, v)]
    for start, end in pairwise(ends):
        step = (end - start) / steps
        for k in range(steps):
            t = start + k * step
            a = acceleration(t, q)
            changes = [verlet(acceleration, t, q, v, a, step, j) for j in SPLITS]
            q = q + sum(weight * change for weight, (change, _) in zip(weights, changes))
            v = v + sum(weight * change for weight, (_, change) in zip(weights, changes))
        states.append((q, v))
    return states


def verlet(acceleration, t, q, v, a, duration, splits):
    """Changes of q and v by velocity Verlet; a is the acceleration at q. Summing changes rounds less than summing states."""
    step = duration / splits
    change_q, change_v = 0.0, 0.0
    for k in range(1, splits + 1):
        half = change_v + step / 2 * a
        change_q = change_q + step * (v + half)
        a = acceleration(t + k * step, q + change_q)
        change_v = half + step / 2 * a
    return change_q, change_v
