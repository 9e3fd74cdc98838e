"""The plane solid by the trapezoidal rule (Newmark, beta = 1/4, gamma = 1/2) with consistent mass.

Step by step this is the method of CalculiX with ALPHA=0. The forces are those of `solid`. From its law,
P_iB = E F_iA (E_AB - E_T_AB) at nu = 0, Newton's tangent is

    dP:dF  ->  K = E/2 ((F F^T)_ij g_m.g_n + (F g_n)_i (F g_m)_j) + 1_ij g_m.S g_n

with g the gradients of the shape functions. The choice of unknowns keeps the hinged face straight: r(0, y) = y d.
"""

import numpy as np
import scipy
import skfem

from .solid import Solid

# Newton's iteration ends at this correction (m); the next one would be its square, below rounding.
CORRECTION = 1e-9
ITERATIONS = 12


class ImplicitRod:
    """A hinged rod of 8-node elements with consistent mass, forces and tangent.

    Unknowns q: component by component, d and the positions of the nodes that are not hinged.
    """

    def __init__(self, rod, along, across, C_T):
        solid = self.solid = Solid(rod, along, across, [[stretch] for stretch in C_T], skfem.ElementQuadS2)
        self.nodes = solid.initial.shape[1]
        self.free = np.setdiff1d(np.arange(self.nodes), solid.hinge)
        one = scipy.sparse.csr_array(
            (np.concatenate([solid.initial[1, solid.hinge], np.ones(len(self.free))]),
             (np.concatenate([solid.hinge, self.free]),
              np.concatenate([np.zeros(len(solid.hinge), int), 1 + np.arange(len(self.free))]))))
        self.field = scipy.sparse.block_diag([one, one], format="csr")  # r of q
        density = skfem.BilinearForm(lambda u, v, _: rod.rho * rod.w * u * v).assemble(solid.basis)
        mass = scipy.sparse.block_diag([density, density], format="csr")
        self.mass = (self.field.T @ mass @ self.field).tocsc()
        self.weight = self.field.T @ (mass @ np.repeat([0.0, -rod.g], self.nodes))
        self.g = solid.gradient.reshape(2, len(solid.volumes), -1)
        self.g_g = np.einsum("apm,apn->pmn", self.g, self.g)
        # Element matrices are indexed (i, m, j, n, element): components i, j and nodes m, n of the element.
        numbers = np.stack([solid.connectivity, self.nodes + solid.connectivity])
        shape = (*numbers.shape[:2], *numbers.shape)
        self.places = [np.broadcast_to(part, shape).ravel() for part in (numbers[:, :, None, None], numbers)]

    def straight(self, along, across):
        """The straight rod, stretched along and across."""
        x, y = self.solid.initial[:, self.free]
        return np.concatenate([[0.0], along * x, [across], across * y])

    def positions(self, q):
        """Positions in the shape of `solid`: (component, node, 1)."""
        return (self.field @ q).reshape(2, self.nodes, 1)

    def force(self, q):
        """Force of stresses and weight on the unknowns."""
        return self.field.T @ self.solid.force(self.positions(q)).ravel() + self.weight

    def tangent(self, q):
        """K for the unknowns."""
        mu, volumes, g = self.solid.mu, self.solid.volumes, self.g
        S11, S22, S12 = mu * self.solid.strain(self.positions(q))
        F = self.solid.F.reshape(2, 2, *S11.shape)
        F_F = np.einsum("p,iape,jape->ijpe", mu * volumes, F, F, optimize=True)
        F_g = np.einsum("iape,apm->impe", F, g)
        K = np.einsum("ijpe,pmn->imjne", F_F, self.g_g, optimize=True)
        K += np.einsum("p,inpe,jmpe->imjne", mu * volumes, F_g, F_g, optimize=True)
        stress = np.einsum("p,abpe,apm,bpn->mne", volumes, [[S11, S12], [S12, S22]], g, g, optimize=True)
        for i in range(2):
            K[i, :, i] += stress
        full = scipy.sparse.coo_array((K.ravel(), self.places), shape=2 * (2 * self.nodes,)).tocsr()
        return self.field.T @ full @ self.field

    def tip(self, q):
        """Position of the axis point at x = L."""
        return self.positions(q)[:, self.solid.tip, 0]


def motion(rod, q, step, every, samples):
    """Yields the unknowns at the start, at rest, and then `samples` times, each after `every` steps."""
    v = np.zeros_like(q)
    a = scipy.sparse.linalg.spsolve(rod.mass, rod.force(q))
    yield q
    for _ in range(samples):
        for _ in range(every):
            q, v, a = stepped(rod, q, v, a, step)
        yield q


def stepped(rod, q, v, a, step):
    """One step: q and v from the mean of the accelerations at both ends; equilibrium at the end gives the new one."""
    known = q + step * v + step**2 / 4 * a
    new = known + step**2 / 4 * a
    for _ in range(ITERATIONS):
        residual = rod.force(new) - rod.mass @ ((new - known) * (4 / step**2))
        solver = scipy.sparse.linalg.splu((rod.tangent(new) + rod.mass * (4 / step**2)).tocsc())
        correction = solver.solve(residual)
        new = new + correction
        if abs(correction).max() < CORRECTION:
            after = (new - known) * (4 / step**2)
            return new, v + step / 2 * (a + after), after
    raise ArithmeticError("Newton's iteration does not converge")
