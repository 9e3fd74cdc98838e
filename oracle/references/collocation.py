"""Boundary value problems of a smooth function on 0 <= s <= 1 by Chebyshev collocation, to many digits.

Points s_j = (1 - cos(j pi/n))/2, the polynomial through the unknown values there, differentiation matrices (Trefethen
2000, chapter 6), Newton's iteration. The error decreases geometrically with n. Residuals have all digits, the matrix of
the iteration is in double precision: each iteration gains about eight digits.
"""

from functools import cache

import numpy as np
from mpmath import mp, mpf

POINTS = 48

# About five are needed, more for a poor first guess.
ITERATIONS = 60


@cache
def derivative(n=POINTS):
    """Matrix of the derivative by s."""
    t = [mp.cos(j * mp.pi / n) for j in range(n + 1)]
    c = [(2 if j in (0, n) else 1) * (-1) ** j for j in range(n + 1)]
    D = [[-2 * mpf(c[i]) / c[j] / (t[i] - t[j]) if i != j else mpf(0) for j in range(n + 1)] for i in range(n + 1)]
    # The derivative of a constant is zero: this sets the diagonal.
    for i, row in enumerate(D):
        row[i] = -mp.fsum(row)
    return D


@cache
def weights(n=POINTS):
    """Weights of Clenshaw and Curtis (n even) for integrals over 0 <= s <= 1 from values at the points."""

    def weight(j):
        theta = j * mp.pi / n
        return (1 - sum(2 * mp.cos(k * theta) / (k * k - 1) for k in range(2, n, 2))
                - mp.cos(n * theta) / (n * n - 1)) / n

    end = mpf(1) / (n * n - 1) / 2
    return [end, *(weight(j) for j in range(1, n)), end]


def integral(values):
    """Integral over 0 <= s <= 1 from values at the points."""
    return mp.fdot(weights(), values)


def solve(f, df, loads):
    """phi at the points for phi'' = f(phi, load), phi(0) = 0, phi'(1) = 0, by load steps up to the last load."""
    D = derivative()
    matrix = np.array(D, float)
    second = matrix @ matrix
    phi = [mpf(0)] * len(D)
    for load in loads:
        for _ in range(ITERATIONS):
            slope = _times(D, phi)
            residual = [a - f(angle, load) for a, angle in zip(_times(D, slope), phi)]
            A = second - np.diag([float(df(angle, load)) for angle in phi])
            # Boundary conditions replace the rows of the two ends.
            residual[0], residual[-1] = phi[0], slope[-1]
            A[0], A[-1] = np.eye(len(D))[0], matrix[-1]
            size = max(map(abs, residual))
            if size == 0:
                break
            change = np.linalg.solve(A, np.array([float(r / size) for r in residual])).tolist()
            phi = [angle - size * mpf(c) for angle, c in zip(phi, change)]
            if size * max(map(abs, change)) < mpf(10) ** (8 - mp.dps):
                break
        else:
            raise ArithmeticError(f"no solution at the load {load}")
    return phi


def _times(matrix, vector):
    return [mp.fdot(row, vector) for row in matrix]
