"""A rod of the paper's elements in floating point: mass, weight, gradients and strain energy, from exact polynomials.

The position field is the polynomial (A.1) with the nodal conditions (A.2) in each element. All quantities are in the
rod's initial axes, where the initial gradient is the unit matrix. The energy does not depend on the axes, because the
law is isotropic.
"""

import numpy as np
import sympy

from ..element import field

# The integrand of Q has degree 8 in x and 4 in y: J has degree 2 in x and 1 in y, dW/dJ is cubic in J.
GAUSS_POINTS = (5, 3)

# Factors of alpha dT along the rod's initial axis and across it.
HEATED_DIRECTIONS = {"none": (0, 0), "1d": (1, 0), "2d": (1, 1), "transverse": (0, 1)}


def stress_and_energy(nu, shear=1):
    """Functions for the first Piola-Kirchhoff stress dW/dJ, the energy density W and dW/dC_T, all divided by mu.

    W = 1/2 C_ijkl E_ij E_kl with C_ijkl = lambda d_ij d_kl + mu (d_ik d_jl + d_il d_jk) contracts to
    lambda/2 (tr E)^2 + mu E:E. E = (J^T J - I)/2 - E_T is (J^T J - C_T)/2 with C_T = I + 2 E_T, the square of
    the stress-free stretch, diagonal here. `shear` multiplies the part with E_12; the paper has no such factor.
    Arguments: J11, J12, J21, J22, C_T along and across; then nu and shear, where a name is given instead of a number.
    """
    J = sympy.Matrix(2, 2, sympy.symbols("J11 J12 J21 J22"))
    C_T = sympy.symbols("C_along C_across")
    nu, shear = (sympy.sympify(str(number), rational=True) for number in (nu, shear))
    E = (J.T * J - sympy.diag(*C_T)) / 2
    W = nu / (1 - 2 * nu) * E.trace() ** 2 + E[0, 0] ** 2 + E[1, 1] ** 2 + 2 * shear * E[0, 1] ** 2
    stress, heating = ([sympy.factor_terms(W.diff(entry)) for entry in entries] for entries in (J, C_T))
    arguments = (*J, *C_T, *nu.free_symbols, *shear.free_symbols)
    return tuple(sympy.lambdify(arguments, result, "numpy", cse=True) for result in (stress, W, heating))


class Beam:
    """A rod of n elements of equal length, for one component of its nodal vectors.

    `mass` is its mass matrix, `weight` the integral of rho S. `gradient` holds the derivatives by x and by y at all
    Gauss points, whose weights are `volumes`. Sizes are rational numbers of sympy.
    """

    def __init__(self, elements, L, h, w, rho):
        mass, weight, gradient, volumes = element(L / elements, h, w, rho)
        points = len(volumes)
        vectors = 5 * elements + 2  # neighbours share r and r_y at their common node
        self.mass, self.weight = np.zeros((vectors, vectors)), np.zeros(vectors)
        whole_gradient = np.zeros((2, elements, points, vectors))
        for k in range(elements):
            own = slice(5 * k, 5 * k + 7)
            self.mass[own, own] += mass
            self.weight[own] += weight
            whole_gradient[:, k, :, own] = gradient
        self.volumes = np.tile(volumes, elements)
        self.gradient = whole_gradient.reshape(2, elements * points, vectors)


def element(length, h, w, rho):
    """Mass matrix, integral of rho S, S_x and S_y at the Gauss points, and weights of the points, for one element."""
    x, y = field.x, field.y
    S = sympy.Matrix(field.shape_functions()).subs(field.l, length)

    def integral(f):
        """Integral over 0 <= x <= length, |y| <= h/2 and the width, term by term; odd powers of y vanish."""
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


def by_components(gradient):
    """The matrix from nodal vectors (x before y) to J11 at all Gauss points, then J12, J21, J22."""
    return np.vstack([np.kron(d, component) for component in np.eye(2) for d in gradient])
