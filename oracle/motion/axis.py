"""A rod of Euler-Bernoulli cable elements in floating point: mass, weight, strains and their energies.

Shape functions, strains and Gauss rules are those of `cable.element`.
"""

import numpy as np
import sympy

from ..cable.element import AXIAL_POINTS, BENDING_POINTS, C, G, HEAT, shape_functions
from ..fixtures.fixture import from_sympy, nearest


def energy_and_stress(strain):
    """Functions of g = r_x, c = r_xx and the thermal strain: strain^2/2, and its derivatives by g and c."""
    density, variables = strain**2 / 2, [v for v in G + C if strain.has(v)]
    stress = [sympy.factor_terms(density.diff(v)) for v in variables]
    arguments = (*variables, HEAT) if strain.has(HEAT) else variables
    return tuple(sympy.lambdify(arguments, result, "numpy", cse=True) for result in (density, stress))


class Axis:
    """A rod of n elements of equal length, for one component of its nodal vectors r, r_x.

    `mass` is its mass matrix, `weight` the integral of rho A S. `stretching` holds S_x at the Gauss points of the
    axial energy, whose weights are `stretched`; `bending` holds S_x and S_xx at those of the bending energy, whose
    weights are `bent`. Sizes are rational numbers of sympy.
    """

    def __init__(self, elements, L, h, w, rho):
        length, density = from_sympy(L) / elements, from_sympy(rho * h * w)
        shapes = shape_functions(length)
        slopes = [S.derivative() for S in shapes]
        bends = [S.derivative() for S in slopes]

        def integral(polynomial):
            return nearest(density * polynomial.integral()(length))

        vectors = 2 * elements + 2  # neighbours share r and r_x at their common node
        self.mass, self.weight = np.zeros((vectors, vectors)), np.zeros(vectors)
        for k in range(elements):
            own = slice(2 * k, 2 * k + 4)
            self.mass[own, own] += [[integral(a * b) for b in shapes] for a in shapes]
            self.weight[own] += [integral(S) for S in shapes]

        def end_to_end(families, points):
            """Derivatives of S at the Gauss points of all elements, and the weights of the points (m)."""
            places, weights = np.polynomial.legendre.leggauss(points)
            places, lengths = nearest(length) / 2 * (1 + places), nearest(length) / 2 * weights
            rows = np.zeros((len(families), elements, points, vectors))
            for k in range(elements):
                for row, family in zip(rows, families):
                    for column, S in enumerate(family, 2 * k):
                        row[k, :, column] = np.polyval([nearest(c) for c in reversed(S.coeffs())], places)
            return rows.reshape(len(families), elements * points, vectors), np.tile(lengths, elements)

        self.stretching, self.stretched = end_to_end([slopes], AXIAL_POINTS)
        self.bending, self.bent = end_to_end([slopes, bends], BENDING_POINTS)
