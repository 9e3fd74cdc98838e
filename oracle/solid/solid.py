"""A rod as a plane solid: quadrilaterals of second order, total Lagrangian, explicit in time.

The law is that of the paper at nu = 0, S = E (E_GL - E_T) = mu (C - C_T) with C_T = I + 2 E_T. The section may deform
in any way, unlike that of a beam element. scikit-fem provides mesh, shape functions and quadrature. All elements are
equal and share one gradient matrix.

Positions r have the shape (component, node, model). Models that differ only in heat are integrated together as columns
of one array; they do not influence one another.
"""

from typing import NamedTuple

import numpy as np
import scipy
import skfem

# Degree of the quadrature: 3 x 3 Gauss points, full integration of elements of second order.
DEGREE = 4


class Rod(NamedTuple):
    """Sizes, material and gravity of a rod, named as in Table 1."""

    L: float
    h: float
    w: float
    rho: float
    E: float
    g: float


class Solid:
    """The rod on a regular mesh of `along` x `across` elements.

    `C_T` holds the squared stress-free stretches along and across, each a list with one entry per model. `element` is
    scikit-fem's ElementQuad2 (9 nodes) or ElementQuadS2 (8 nodes). The mass is diagonal: the diagonal of each element's
    consistent mass, scaled to the mass of the element. For 9 nodes that is Simpson's rule, which keeps the order.
    """

    def __init__(self, rod, along, across, C_T, element=skfem.ElementQuad2):
        self.rod, self.models = rod, len(C_T[0])
        # y is zero on the axis, which must be a line of nodes.
        x, y = np.linspace(0, rod.L, along + 1), np.linspace(-rod.h / 2, rod.h / 2, across + 1)
        basis = self.basis = skfem.Basis(skfem.MeshQuad.init_tensor(x, y), element(), intorder=DEGREE)
        self.initial = basis.doflocs  # (component, node)
        self.connectivity = basis.element_dofs  # (node of the element, element)
        values = np.array([field.value[0] for (field,) in basis.basis])  # (node, point) of the first element
        gradients = np.array([field.grad for (field,) in basis.basis])  # (node, direction, element, point)
        self.volumes = rod.w * basis.dx[0]
        assert np.ptp(gradients, axis=2).max() < 1e-9 * gradients.max(), "all elements must have the same gradients"
        (nodes, points), count = values.shape, self.connectivity.shape[1]
        self.gradient = gradients[:, :, 0].reshape(nodes, 2 * points).T
        diagonal = values**2 @ self.volumes
        self.element_mass = diagonal * (rod.rho * self.volumes.sum() / diagonal.sum())
        self.scatter = scipy.sparse.csr_array(
            (np.ones(nodes * count), (self.connectivity.ravel(), np.arange(nodes * count))))
        self.mass = self.scatter @ np.repeat(self.element_mass, count)
        # Nodal force of the stresses at the points, with the factor -mu.
        self.mu = rod.E / 2
        self.divergence = -self.mu * (self.gradient * np.tile(self.volumes, 2)[:, None]).T
        self.C_T = np.array([np.tile(stretch, (points, count)) for stretch in C_T])
        # Work space: allocating arrays in each step would cost more than the arithmetic.
        columns = count * self.models
        self.local, self.F, self.P = (np.empty((2, n, columns)) for n in (nodes, 2 * points, 2 * points))
        self.S, self.product = np.empty((3, points, columns)), np.empty((2, points, columns))
        self.hinge = np.flatnonzero(np.isclose(self.initial[0], 0))
        axis = np.isclose(self.initial[1], 0)
        self.tip = int(np.flatnonzero(axis & np.isclose(self.initial[0], rod.L))[0])

    def straight(self, along, across):
        """The straight rod, stretched along and across by two numbers per model."""
        return self.initial[:, :, None] * np.array([along, across])[:, None, :]

    def strain(self, r):
        """C - C_T, twice the elastic strain: 11, 22, 12 at all points. Result and F_ij remain in the work space."""
        np.take(r, self.connectivity, axis=1, out=self.local.reshape(2, *self.connectivity.shape, -1), mode="clip")
        np.matmul(self.gradient, self.local, out=self.F)
        F = self.F.reshape(2, 2, *self.S.shape[1:])
        for entry, (i, j) in zip(self.S, ((0, 0), (1, 1), (0, 1))):
            np.multiply(F[:, i], F[:, j], out=self.product)
            np.add(*self.product, out=entry)
        self.S[:2] -= self.C_T
        return self.S

    def force(self, r):
        """Nodal forces of the stresses: P = F S at all points, then its divergence."""
        S11, S22, S12 = self.strain(r)
        F, P = (work.reshape(2, 2, *self.S.shape[1:]) for work in (self.F, self.P))
        for j, column in enumerate(((S11, S12), (S12, S22))):
            np.multiply(F[:, 0], column[0], out=P[:, j])
            np.multiply(F[:, 1], column[1], out=self.product)
            P[:, j] += self.product
        np.matmul(self.divergence, self.P, out=self.local)
        return np.array([self.scatter @ part.reshape(-1, self.models) for part in self.local])

    def acceleration(self, r):
        """Accelerations under gravity. The hinged face x = 0 is y d with a free vector d: it rotates and stretches."""
        a = self.force(r)
        y, mass = self.initial[1, self.hinge], self.mass[self.hinge]
        spin = np.einsum("n,inm->im", y, a[:, self.hinge]) / (mass @ y**2)
        a /= self.mass[:, None]
        a[1] -= self.rod.g
        a[:, self.hinge] = spin[:, None] * y[:, None]
        return a

    def energies(self, r, v):
        """Kinetic, strain and potential energy of each model; the potential is zero at the hinge's height."""
        S11, S22, S12 = self.strain(r)
        density = (S11**2 + S22**2 + 2 * S12**2).reshape(len(self.volumes), -1, self.models).sum(1)
        return np.array([self.mass @ (v**2).sum(0) / 2, self.mu / 4 * self.volumes @ density,
                         self.rod.g * self.mass @ r[1]])

    def stable_step(self):
        """Stability limit of the step of `motion` at rest: no mesh vibrates faster than a single element of it."""
        points = len(self.volumes)
        D = np.kron(np.diag([2.0, 1, 1, 2]) + np.fliplr(np.diag([0.0, 1, 1, 0])), np.diag(self.volumes)) * self.mu
        B = np.zeros((2, 2, points, 2, len(self.element_mass)))  # F_ij by component i and node
        for i in range(2):
            B[i, :, :, i] = self.gradient.reshape(2, points, -1)
        B = B.reshape(4 * points, -1)
        fastest = scipy.linalg.eigh(B.T @ D @ B, np.diag(np.tile(self.element_mass, 2)), eigvals_only=True)[-1]
        return np.sqrt(12 / fastest)


def motion(solid, r, step, every, samples):
    """Yields r and v at the start, at rest, and then `samples` times, each after `every` steps.

    Velocity Verlet with the acceleration taken at r + step^2/12 r'' (Takahashi and Imada). This raises the order for
    linear vibrations from two to four; the method stays symplectic up to terms of step^4.
    """
    def acceleration(r):
        return solid.acceleration(r + step**2 / 12 * solid.acceleration(r))

    a = acceleration(r)
    yield r, np.zeros_like(r)
    r, v = r.copy(), step / 2 * a  # half a step ahead of r
    for _ in range(samples):
        for _ in range(every):
            r += step * v
            a = acceleration(r)
            a *= step
            v += a
        yield r.copy(), v - a / 2
