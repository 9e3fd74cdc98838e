"""One element in exact rational numbers: its energies as polynomials, with forces, tangents and mass as derivatives.

A function of the element coordinates and of the nodal coordinates is a polynomial in the ring Q[x, y, e1 ... e14].
Derivatives with respect to e and integrals over the element are operations on polynomials; nothing is approximated. The
premises are (A.1), (A.2), Hooke's law and the definitions of the strains. Only functions with `printed` in their name
follow further formulas of the paper.
"""

from functools import cache, cached_property
from itertools import product

import sympy
from flint import fmpq, fmpq_mat, fmpq_mpoly_ctx

from ..fixtures.fixture import from_sympy, to_sympy
from . import field

DOF = 14
PLANE = range(2)
NAMES = ["x", "y"] + [f"e{i}" for i in range(1, DOF + 1)]
RING = fmpq_mpoly_ctx.get(NAMES)
E_SYMBOLS = RING.gens()[2:]

# Parts W_1, W_2, W_3 of the energy density (lambda + 2 mu) W_1 + lambda W_2 + (shear weight) W_3 without heat, in
# eps_1, eps_2 and eps_3 = E_12. They lead to K_1, K_2, K_3 of (20) and (21).
EPS = sympy.symbols("eps_1:4")
PARTS = ((EPS[0] ** 2 + EPS[1] ** 2) / 2, EPS[0] * EPS[1], EPS[2] ** 2 / 2)


def constant(polynomial):
    """Value of a constant polynomial."""
    assert polynomial.is_constant(), "the polynomial must be a number"
    return polynomial(*[0] * len(NAMES))


@cache
def shape_functions(length):
    """S_1 ... S_7 of an element of this length as polynomials in x and y."""
    polynomials = []
    for shape in field.shape_functions():
        terms = sympy.Poly(shape.subs(field.l, to_sympy(length)), field.x, field.y).terms()
        exponents = {(*powers, *[0] * DOF): from_sympy(c) for powers, c in terms}
        polynomials.append(RING.from_dict(exponents))
    return polynomials


class Element:
    """Quantities of the equations (1)-(22) for one element in one `State`."""

    def __init__(self, state):
        self.state = state
        self.shapes = shape_functions(state.l)
        # Fails for an initial element that is not straight: its gradient is not constant.
        gradient = self.gradient(state.e0)
        self.J_0 = fmpq_mat([[constant(entry) for entry in row] for row in gradient])
        self.J_0_inverse = self.J_0.inv()
        self.lam = state.E * state.nu / ((1 + state.nu) * (1 - 2 * state.nu))
        self.mu = state.E / (2 * (1 + state.nu))

    # Kinematics. `e` holds numbers, or the ring's variables e1 ... e14.

    def position(self, e):
        """Position r: the sum of shape functions times nodal vectors."""
        return [sum(S * e[2 * k + i] for k, S in enumerate(self.shapes)) for i in PLANE]

    def gradient(self, e):
        """The derivative of r with respect to (x, y)."""
        return [[r.derivative(name) for name in ("x", "y")] for r in self.position(e)]

    def deformation_gradient(self, e):
        """J: the derivative of r with respect to the initial position, in global axes."""
        G, inverse = self.gradient(e), self.J_0_inverse
        return [[sum(G[i][k] * inverse[k, j] for k in PLANE) for j in PLANE] for i in PLANE]

    def mechanical_strain(self, e):
        """The Green-Lagrange strain (J^T J - I)/2."""
        J = self.deformation_gradient(e)
        C = [[sum(J[k][i] * J[k][j] for k in PLANE) for j in PLANE] for i in PLANE]
        return [[(C[i][j] - int(i == j)) * fmpq(1, 2) for j in PLANE] for i in PLANE]

    @cached_property
    def thermal_strain(self):
        """The tensor alpha dT I ("2d"), alpha dT t t^T with the initial axis t ("1d"), or zero ("none")."""
        state = self.state
        t = [self.J_0[i, 0] for i in PLANE]
        directions = {
            "2d": [[fmpq(int(i == j)) for j in PLANE] for i in PLANE],
            "1d": [[t[i] * t[j] for j in PLANE] for i in PLANE],
            "none": [[fmpq(0)] * 2] * 2,
        }[state.model]
        return [[state.alpha * state.dT * entry for entry in row] for row in directions]

    def strain(self, e):
        """The mechanical strain minus the thermal strain."""
        E, T = self.mechanical_strain(e), self.thermal_strain
        return [[E[i][j] - T[i][j] for j in PLANE] for i in PLANE]

    # Integrals and energies.

    def integral(self, density):
        """The integral over the volume 0 <= x <= l, -h/2 <= y <= h/2, of width w."""
        half = self.state.h / 2
        for name, low, high in (("x", fmpq(0), self.state.l), ("y", -half, half)):
            primitive = density.integral(name)
            density = primitive.subs({name: high}) - primitive.subs({name: low})
        return density * self.state.w

    def hessian(self, polynomial):
        """Second derivatives with respect to e1 ... e14."""
        rows = [polynomial.derivative(name) for name in NAMES[2:]]
        return [[row.derivative(name) for name in NAMES[2:]] for row in rows]

    def at_state(self, polynomial):
        """The value of a polynomial in e alone at the state's e."""
        return polynomial(0, 0, *self.state.e)

    @cached_property
    def generic_strain(self):
        """The strain for arbitrary e1 ... e14."""
        return self.strain(E_SYMBOLS)

    @cached_property
    def energy_density(self):
        """C_ijkl E_ij E_kl / 2 with C_ijkl = lambda d_ij d_kl + mu (d_ik d_jl + d_il d_jk)."""
        E, density = self.generic_strain, 0
        for i, j, k, m in product(PLANE, repeat=4):
            stiffness = self.lam * ((i == j) * (k == m))
            stiffness += self.mu * ((i == k) * (j == m) + (i == m) * (j == k))
            if stiffness != 0:
                density += E[i][j] * E[k][m] * (stiffness / 2)
        return density

    @cached_property
    def D(self):
        """Stress from strain, both as the vectors (11, 22, 12): sigma = D eps."""
        lam, mu = self.lam, self.mu
        return fmpq_mat([[lam + 2 * mu, lam, 0], [lam, lam + 2 * mu, 0], [0, 0, 2 * mu]])

    @cached_property
    def energy_density_printed_shear(self):
        """eps^T D eps / 2 with the shear strain counted once (E3): half the tensor's shear part."""
        eps = self.vector(self.generic_strain)
        pairs = [(k, n) for k in range(3) for n in range(3) if self.D[k, n] != 0]
        return sum(eps[k] * eps[n] * (self.D[k, n] / 2) for k, n in pairs)

    # Poisson's terms on the axis alone, beyond the paper: a remedy for thickness locking.

    def own(self, tensor):
        """Components (11, 22, 2 12) in the rod's own axes of a tensor in global axes; J_0 rotates own axes into global ones."""
        R, (t, n) = self.J_0, PLANE
        assert R.transpose() * R == fmpq_mat([[1, 0], [0, 1]])

        def entry(a, b):
            return sum(tensor[i][j] * (R[i, a] * R[j, b]) for i in PLANE for j in PLANE)

        return [entry(t, t), entry(n, n), 2 * entry(t, n)]

    @cached_property
    def D_own(self):
        """Elasticity matrix for strains (11, 22, 2 12), with the shear doubled."""
        lam, mu = self.lam, self.mu
        return fmpq_mat([[lam + 2 * mu, lam, 0], [lam, lam + 2 * mu, 0], [0, 0, mu]])

    @cached_property
    def D_0(self):
        """Elasticity matrix off the axis, without Poisson's contraction: E* = E/(1 - nu^2) in both directions."""
        alone = self.state.E / (1 - self.state.nu**2)
        return fmpq_mat([[alone, 0, 0], [0, alone, 0], [0, 0, self.mu]])

    @cached_property
    def energy_axis(self):
        """1/2 int eps^T D_0 eps dV + 1/2 h w int eps(x, 0)^T (D - D_0) eps(x, 0) dx, for arbitrary e."""
        eps = self.own(self.generic_strain)
        on_axis = [component.subs({"y": 0}) for component in eps]

        def density(eps, D):
            return sum(eps[k] * eps[n] * (D[k, n] / 2) for k in range(3) for n in range(3))

        # A density that is uniform over the section integrates to h w times its integral along the axis.
        return self.integral(density(eps, self.D_0) + density(on_axis, self.D_own - self.D_0))

    # Uniaxial stress in both directions, beyond the paper: a law for struts.

    @cached_property
    def D_uniaxial(self):
        """Elasticity matrix for strains (11, 22, 2 12) of fibres along and across that do not contract: diag(E, E, G).

        Each normal stress is that of a bar, sigma = E eps. The shear modulus is found as that of an isotropic body:
        a shear g is the stretch g/2 and the compression g/2 of the diagonals, so it takes the stress
        sigma = E/(1 + nu) g/2 by Hooke's law (1 + nu) sigma/E = g/2.
        """
        fibre, shear = self.state.E, self.state.E / (1 + self.state.nu) / 2
        return fmpq_mat([[fibre, 0, 0], [0, fibre, 0], [0, 0, shear]])

    @cached_property
    def energy_uniaxial(self):
        """int E (eps_11^2 + eps_22^2)/2 + G (2 eps_12)^2/2 dV in the rod's own axes, for arbitrary e."""
        return self.integral(sum(self.D_uniaxial[k, k] / 2 * eps**2 for k, eps in enumerate(self.own(self.generic_strain))))

    @cached_property
    def energy(self):
        """U for arbitrary e."""
        return self.integral(self.energy_density)

    @cached_property
    def energy_printed_shear(self):
        """U of (18) as printed, for arbitrary e."""
        return self.integral(self.energy_density_printed_shear)

    def force(self, energy):
        """dU/de at the state."""
        return [self.at_state(energy.derivative(name)) for name in NAMES[2:]]

    def tangent(self, energy):
        """The second derivative of U at the state."""
        return [[self.at_state(entry) for entry in row] for row in self.hessian(energy)]

    @cached_property
    def kinetic_energy(self):
        """T for arbitrary nodal velocities; they are the variables e1 ... e14 here."""
        velocity = self.position(E_SYMBOLS)
        return self.integral(sum(v * v for v in velocity) * (self.state.rho / 2))

    @cached_property
    def mass(self):
        """M: the second derivative of the kinetic energy."""
        return fmpq_mat([[constant(m) for m in row] for row in self.hessian(self.kinetic_energy)])

    @cached_property
    def gravity_force(self):
        """Q_w: derivative of the work of the weight, the integral of rho g . r."""
        r, state = self.position(E_SYMBOLS), self.state
        work = self.integral(sum(g * c for g, c in zip(state.gravity, r)) * state.rho)
        return [constant(work.derivative(name)) for name in NAMES[2:]]

    # The intermediates of (11)-(21).

    @staticmethod
    def vector(tensor):
        """A symmetric tensor as (11, 22, 12)."""
        return [tensor[0][0], tensor[1][1], tensor[0][1]]

    @cached_property
    def strain_at_state(self):
        """eps_1, eps_2, eps_3 of the state as polynomials in x and y."""
        return self.vector(self.strain(self.state.e))

    @cached_property
    def strain_hessians(self):
        """The second derivatives of eps_1, eps_2, eps_3 with respect to e: polynomials in x, y."""
        return [self.hessian(eps) for eps in self.vector(self.generic_strain)]

    def weighted(self, weights):
        """The integral of sum_k weights_k d2(eps_k)/de de, a matrix."""

        def entry(i, j):
            total = sum(weight * H[i][j] for weight, H in zip(weights, self.strain_hessians))
            return constant(self.integral(total))

        return fmpq_mat([[entry(i, j) for j in range(DOF)] for i in range(DOF)])

    @cached_property
    def K_parts(self):
        """K_1, K_2, K_3, from the three parts W_m of the energy density.

        A strain is quadratic in e, so the derivative of the integral of W_m is K_m e, where K_m is
        the integral of sum_k (dW_m/d eps_k) d2(eps_k)/de de.
        """
        parts = []
        for part in PARTS:
            curvature = sympy.hessian(part, EPS)
            weights = [
                sum(int(curvature[k, n]) * eps for n, eps in enumerate(self.strain_at_state))
                for k in range(3)
            ]
            parts.append(self.weighted(weights))
        return parts

    @cached_property
    def K_3_printed(self):
        """K_3 as (21) prints it (E2): the shear strain less 1/2, and without heat."""
        shear = self.mechanical_strain(self.state.e)[0][1]
        return self.weighted([RING.constant(0), RING.constant(0), shear - fmpq(1, 2)])

    def K(self, shear_weight):
        """(lambda + 2 mu) K_1 + lambda K_2 + shear_weight K_3."""
        K_1, K_2, K_3 = self.K_parts
        return (self.lam + 2 * self.mu) * K_1 + self.lam * K_2 + shear_weight * K_3
