"""Limit of the paper's element for many elements: the cantilever of its field and its strain energy.

The field r(s) + y d(s), which is (A.1) within an element, has the deformation gradient [p + y kappa, d] with p = r' and
kappa = d'. The energy of a unit length, divided by w,

    W(p, d, kappa) = int lambda/2 (E_11 + E_22)^2 + mu (E_11^2 + E_22^2 + 2 E_12^2) dy,
    2 E_11 = |p + y kappa|^2 - 1,   2 E_22 = |d|^2 - 1,   2 E_12 = (p + y kappa) . d,

is a polynomial. The load is a dead load F downwards at the tip; the clamp is that of scenes, which holds r and the
direction of the section and leaves its height free. Two methods:

  * the equations of equilibrium dW/dp = (0, -F/w), (dW/dkappa)' = dW/dd with dW/dkappa = 0 where nothing holds d,
    by Chebyshev collocation of p and d;
  * the least potential energy among Legendre polynomials p and d (Rayleigh and Ritz), Gauss's rule.

Both use Newton's iteration in double precision, by load steps, and then refine with residuals of all digits. The result
is the limit of any conforming element of this field and energy. Reissner's law has a different limit.
"""

from functools import cache

import numpy as np
import sympy
from mpmath import mp, mpf

from . import collocation, reissner, value

SOURCE = "law: the paper's strain energy, (18) with (13)-(17) at no heat; limit derived and solved here"
UNITS = {"tip.x": "m", "tip.y": "m"}
METHODS = ("Chebyshev collocation of equilibrium", "Rayleigh and Ritz's method with Legendre polynomials")

# The thickness has boundary layers of h/5 at both ends, which polynomials resolve slowly: fewer digits than elsewhere.
DIGITS = 16
# For each beam: collocation points, Legendre polynomials.
FINE = {"stubby": (40, 28), "slender": (64, 48)}
# Load steps.
STEPS = 6


@cache
def section():
    """First and second derivatives of W by (p, d, kappa), as functions of these six and of the section's constants."""
    z = sympy.symbols("p_1 p_2 d_1 d_2 k_1 k_2")
    numbers = area, inertia, fourth, lame, mu = sympy.symbols("area inertia fourth lame mu")
    y = sympy.Symbol("y")
    p, d, k = (sympy.Matrix(z[n:n + 2]) for n in (0, 2, 4))
    fibre = p + y * k
    E_11, E_22, E_12 = (fibre.dot(fibre) - 1) / 2, (d.dot(d) - 1) / 2, fibre.dot(d) / 2
    density = sympy.expand(lame / 2 * (E_11 + E_22) ** 2 + mu * (E_11**2 + E_22**2 + 2 * E_12**2))
    # Integrals of y^n over the height remain symbols, so that no fraction is rounded to a double.
    W = sum(moment * density.coeff(y, n) for n, moment in ((0, area), (2, inertia), (4, fourth)))
    arguments = (*z, *numbers)
    first = [W.diff(a) for a in z]
    second = [[entry.diff(b) for b in z] for entry in first]
    return (sympy.lambdify(arguments, first, "numpy", cse=True), sympy.lambdify(arguments, second, "numpy", cse=True))


class Cantilever:
    """A cantilever of unit length and unit modulus; `numbers` are the constants of the section."""

    def __init__(self, L, h, w, E, nu, F):
        L, h, w, E, nu, F = map(value.exact, (L, h, w, E, nu, F))
        height, mu = h / L, 1 / (2 * (1 + nu))
        self.L, self.F = L, F / (E * w * L)
        self.numbers = (height, height**3 / 12, height**5 / 80, 2 * mu * nu / (1 - 2 * nu), mu)

    def forces(self, z):
        """dW/dz at all points, for z in doubles or in mpmath's numbers."""
        numbers = self.numbers if z[0].dtype == object else map(float, self.numbers)
        return section()[0](*z, *numbers)

    def stiffness(self, z):
        """Second derivatives in double precision, 6 by 6 numbers at each point."""
        rows = section()[1](*z, *map(float, self.numbers))
        return np.array([[entry + 0 * z[0] for entry in row] for row in rows])

    def tip(self, method):
        """Tip position by a method: r(1) = int p."""
        x = method.straight()
        for step in range(1, STEPS + 1):
            x = newton(method, x, self.F * step / STEPS, float)
        x = newton(method, x, self.F, object)
        return {name: self.L * component for name, component in zip(("tip.x", "tip.y"), method.ends(x))}


def newton(method, x, load, kind):
    """Solution near x, in doubles (`float`) or in mpmath's numbers (`object`) with a matrix of doubles."""
    x = np.array([mpf(entry) for entry in x] if kind is object else x, kind)
    # The error after a correction is far smaller than the correction.
    smallest = mpf(10) ** (-DIGITS - 2) if kind is object else 1e-9
    load = load if kind is object else float(load)
    for _ in range(60):
        residual = method.residual(x, load)
        size = max(map(abs, residual))
        if size == 0:
            return x
        change = np.linalg.solve(method.matrix(x.astype(float)), (residual / size).astype(float))
        x = x - change.astype(kind) * size
        if size * max(map(abs, change)) <= smallest:
            return x
    raise ArithmeticError(f"no equilibrium at the load {load}")


class Collocation:
    """Collocation; unknowns: p_1, p_2, d_1, d_2 at Chebyshev's points."""

    def __init__(self, rod, points):
        self.rod, self.n = rod, points + 1
        self.D = np.array(collocation.derivative(points), object)
        self.weights = np.array(collocation.weights(points), object)

    def straight(self):
        return np.repeat([1.0, 0.0, 0.0, 1.0], self.n)

    def fields(self, x, D):
        p, d = x.reshape(2, 2, self.n)
        return [*p, *d, *(D @ part for part in d)]

    def residual(self, x, load):
        D = self.D if x.dtype == object else self.D.astype(float)
        p_1, p_2, d_1, d_2, k_1, k_2 = self.rod.forces(self.fields(x, D))
        rows = [p_1, p_2 + load, D @ k_1 - d_1, D @ k_2 - d_2]
        # The clamp holds the direction of the section; no moment and no force through the height elsewhere at the ends.
        rows[2][0], rows[3][0], rows[2][-1], rows[3][-1] = x[2 * self.n], k_2[0], k_1[-1], k_2[-1]
        return np.concatenate(rows)

    def matrix(self, x):
        n, D = self.n, self.D.astype(float)
        H = self.rod.stiffness(self.fields(x, D))
        rates = [np.hstack([*(np.diag(H[i, a]) for a in (0, 1)),
                            *(np.diag(H[i, a]) + H[i, a + 2][:, None] * D for a in (2, 3))]) for i in range(6)]
        rows = [rates[0], rates[1], D @ rates[4] - rates[2], D @ rates[5] - rates[3]]
        ends = np.eye(4 * n)[2 * n], rates[5][0], rates[4][-1], rates[5][-1]
        rows[2][0], rows[3][0], rows[2][-1], rows[3][-1] = ends
        return np.vstack(rows)

    def ends(self, x):
        return [self.weights @ part for part in x[:2 * self.n].reshape(2, self.n)]


class Ritz:
    """Ritz's method; unknowns: factors of Legendre polynomials in p_1, p_2, d_1, d_2, those of d_1 minus their value at s = 0."""

    def __init__(self, rod, degree):
        self.rod = rod
        t, weights = gauss(3 * degree // 2)
        P, slope = legendre(t, degree)
        start, _ = legendre(np.array([mpf(-1)]), degree)
        # p_1, p_2, d_1, d_2, d_1', d_2'. s = (1 + t)/2: derivatives take a factor 2, weights one half.
        self.basis = [P, P, (P - start)[:, 1:], P, 2 * slope[:, 1:], 2 * slope]
        self.weights = weights / 2
        self.places = np.cumsum([part.shape[1] for part in self.basis[:3]])

    def straight(self):
        x = np.zeros(sum(part.shape[1] for part in self.basis[:4]))
        x[0] = x[self.places[2]] = 1.0
        return x

    def residual(self, x, load):
        basis, weights = self._as(x.dtype)
        forces = self.rod.forces(self.fields(x, basis))
        forces[1] = forces[1] + load
        rows = [B.T @ (weights * force) for B, force in zip(basis, forces)]
        return np.concatenate([rows[0], rows[1], rows[2] + rows[4], rows[3] + rows[5]])

    def matrix(self, x):
        basis, weights = self._as(float)
        H = self.rod.stiffness(self.fields(x, basis)) * weights
        # Group of unknowns of each field; d' depends on those of d.
        own = (0, 1, 2, 3, 2, 3)
        blocks = [[sum(basis[i].T @ (H[i, j][:, None] * basis[j]) for i in range(6) for j in range(6)
                       if (own[i], own[j]) == (row, column)) for column in range(4)] for row in range(4)]
        return np.block(blocks)

    def ends(self, x):
        return [self.weights @ part for part in self.fields(x, self.basis)[:2]]

    def fields(self, x, basis):
        factors = np.split(x, self.places)
        return [B @ factor for B, factor in zip(basis, [*factors, *factors[2:]])]

    def _as(self, kind):
        numbers = [*self.basis, self.weights]
        *basis, weights = numbers if kind == object else [part.astype(float) for part in numbers]
        return basis, weights


def legendre(points, degree):
    """P_n and P_n' for n below `degree`, with one row per point of -1 ... 1."""
    P, slope = [0 * points + 1, points], [0 * points, 0 * points + 1]
    for n in range(1, degree - 1):
        P.append(((2 * n + 1) * points * P[n] - n * P[n - 1]) / (n + 1))
        slope.append(slope[n - 1] + (2 * n + 1) * P[n])
    return np.array(P, object).T, np.array(slope, object).T


def gauss(m):
    """Nodes and weights of Gauss's rule with m points, refined from doubles by Newton's iteration."""
    t = np.array([mpf(node) for node in np.polynomial.legendre.leggauss(m)[0].tolist()], object)
    for _ in range(3):
        before, here = 0 * t + 1, t
        for n in range(1, m):
            before, here = here, ((2 * n + 1) * t * here - n * before) / (n + 1)
        slope = m * (before - t * here) / (1 - t * t)
        t, last = t - here / slope, slope
    return t, 2 / ((1 - t * t) * last**2)


def entries():
    """Entries: the two cantilevers of `reissner` at nu = 0."""
    with mp.workdps(value.WORKING):
        for beam, sizes in reissner.SIZES.items():
            rod = Cantilever(nu=0.0, **sizes)
            points, degree = FINE[beam]
            tips = (rod.tip(method) for method in (Collocation(rod, points), Ritz(rod, degree)))
            yield {
                "id": f"director-{beam}",
                "tags": ["statics", "green-lagrange", "element", "cantilever", beam],
                "problem": "tip of the cantilever of the paper's field and strain energy, nu = 0, under a dead "
                "load at its tip",
                "source": SOURCE,
                "parameters": sizes | {"nu": 0.0},
                "values": value.agreed(METHODS, UNITS, *tips, digits=DIGITS),
            }
