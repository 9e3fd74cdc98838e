"""The quantities of `fixtures/equations.json`: description, unit, shape, and how each is read from an `Element`."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

from flint import fmpq, fmpq_mat

from ..fixtures import fixture
from ..fixtures.fixture import from_sympy, to_sympy
from . import field
from .element import DOF, E_SYMBOLS, NAMES, PLANE

ZERO = fmpq(0)


class AtPoint:
    """An element seen at one material point (x, y)."""

    def __init__(self, element, point):
        self.element, self.point, self.state = element, point, element.state

    def of(self, polynomials):
        """Values at the point of nested lists of polynomials in x and y."""
        return fixture.each(lambda p: p(*self.point, *[0] * DOF), polynomials)

    @cached_property
    def _gradient_of_each(self):
        """J for each unit vector of nodal coordinates."""
        units = [[fmpq(int(i == j)) for j in range(DOF)] for i in range(DOF)]
        return [self.of(self.element.deformation_gradient(unit)) for unit in units]

    def polarised(self, a, b):
        """The matrix B with e^T B f = (J(e)^T J(f))_ab, from unit vectors because J is linear in e."""
        J = self._gradient_of_each
        return [[sum((P[k][a] * R[k][b] for k in PLANE), ZERO) for R in J] for P in J]

    def form_hessian(self, k):
        """Second derivative of 2 eps_k, a quadratic form plus a constant."""
        return [[2 * entry for entry in row] for row in self.of(self.element.strain_hessians[k])]

    @cached_property
    def stress(self):
        """The stress vector D eps."""
        return column(self.element.D * as_column(self.of(self.element.strain_at_state)))


def as_column(vector):
    """A list as a matrix of one column."""
    return fmpq_mat([[entry] for entry in vector])


def column(matrix):
    """A matrix of one column as a list."""
    return [row[0] for row in matrix.tolist()]


def coefficients(state, expressions):
    """Rows [a_k, b_k] from expressions in one component's nodal values, evaluated for both components of e."""
    rows = []
    for expression in expressions:
        row = []
        for i in PLANE:
            values = {v: to_sympy(q) for v, q in zip(field.NODAL, state.e[i::2], strict=True)}
            row.append(from_sympy(expression.subs({field.l: to_sympy(state.l), **values})))
        rows.append(row)
    return rows


def from_polynomial(at, monomials):
    """Value of the polynomial (A.1), or of a derivative of it, from its monomials."""
    place = dict(zip((field.x, field.y), map(to_sympy, at.point)))
    values = [from_sympy(m.subs(place)) for m in monomials]
    rows = coefficients(at.state, field.coefficients())
    return [sum((m * row[i] for m, row in zip(values, rows)), ZERO) for i in PLANE]


def nodal_sum(at):
    """Position (A.4), the sum of shape functions times nodal vectors."""
    shapes = at.of(at.element.shapes)
    return [sum((S * q for S, q in zip(shapes, at.state.e[i::2])), ZERO) for i in PLANE]


def nodal_coordinates(element):
    """Nodal values (A.2) of the polynomial with the coefficients (A.3)."""
    rows = coefficients(element.state, field.coefficients())
    length = {field.l: to_sympy(element.state.l)}
    components = []
    for i in PLANE:
        component = field.polynomial([to_sympy(row[i]) for row in rows])
        components.append([from_sympy(v.subs(length)) for v in field.nodal_values(component)])
    return [value for pair in zip(*components) for value in pair]


def acceleration(element):
    """Nodal accelerations that solve (22) under gravity."""
    load = as_column(element.gravity_force) - as_column(element.force(element.energy))
    return column(element.mass.solve(load))


def residual(element):
    """Residual M a + Q_e - Q_w for the acceleration a = edot / (1 s), which does not solve (22)."""
    forces = as_column(element.force(element.energy)) - as_column(element.gravity_force)
    return column(element.mass * as_column(element.state.edot) + forces)


@dataclass(frozen=True)
class Quantity:
    """Description of a quantity, and the function that reads its exact value."""

    what: str
    shape: tuple
    unit: str
    value: Callable
    per: str = "element"
    form: str = "consistent"


def point(what, shape, unit, value):
    """A quantity that varies over the element; `value` takes an `AtPoint`."""
    return Quantity(what, shape, unit, value, per="point")


SQUARE = (DOF, DOF)
NODAL_LENGTH = "m; slopes 1"
NODAL_FORCE = "N; slopes N m"
NODAL_STIFFNESS = "N/m; slopes N, N m"

QUANTITIES = {
    "A.1.r": point("position from the polynomial", (2,), "m", lambda at: from_polynomial(at, field.MONOMIALS)),
    **{f"A.1.r_{v}": point(f"the polynomial's derivative in {v}", (2,), "1",
                           lambda at, v=v: from_polynomial(at, [m.diff(v) for m in field.MONOMIALS])) for v in "xy"},
    "A.2.e": Quantity("nodal conditions asked of the field", (DOF,), NODAL_LENGTH, nodal_coordinates),
    "A.3.coefficients": Quantity(
        "rows [a_k, b_k], k = 0 ... 6", (7, 2), "m^(1 - degree)",
        lambda el: coefficients(el.state, field.coefficients())),
    "A.3.coefficients/printed": Quantity(
        "the same with a_1, b_1 as printed (E1)", (7, 2), "m^(1 - degree)",
        lambda el: coefficients(el.state, field.coefficients_printed()), form="printed"),
    "A.4.r": point("position, summed nodal vector by nodal vector", (2,), "m", nodal_sum),
    "1.r": point("position", (2,), "m", lambda at: at.of(at.element.position(at.state.e))),
    "2.S": point("shape function matrix", (2, DOF), "1; slopes m",
                 lambda at: at.of([[r.derivative(name) for name in NAMES[2:]]
                                   for r in at.element.position(E_SYMBOLS)])),
    "3.S": point("shape functions S_1 ... S_7", (7,), "1; slopes m", lambda at: at.of(at.element.shapes)),
    "3.S_x": point("their derivatives in x", (7,), "1/m; slopes 1",
                   lambda at: at.of([S.derivative("x") for S in at.element.shapes])),
    "3.S_y": point("their derivatives in y", (7,), "1/m; slopes 1",
                   lambda at: at.of([S.derivative("y") for S in at.element.shapes])),
    "4.nodes": Quantity("rows r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k", (7, 2), NODAL_LENGTH,
                        lambda el: [list(el.state.e[k:k + 2]) for k in range(0, DOF, 2)]),
    "5.rdot": point("velocity", (2,), "m/s", lambda at: at.of(at.element.position(at.state.edot))),
    "6.T": Quantity("kinetic energy", (), "J", lambda el: el.kinetic_energy(0, 0, *el.state.edot)),
    "7.M": Quantity("mass matrix, second derivative of T", SQUARE, "kg; slopes kg m, kg m^2",
                    lambda el: el.mass.tolist()),
    "8.epsilon_T": Quantity("thermal strain (11, 22, 12) in global axes", (3,), "1",
                            lambda el: el.vector(el.thermal_strain)),
    "9.J_0": point("initial gradient dr_0/d(x, y)", (2, 2), "1", lambda at: at.element.J_0.tolist()),
    "9.J": point("deformation gradient dr/dr_0", (2, 2), "1",
                 lambda at: at.of(at.element.deformation_gradient(at.state.e))),
    "10.epsilon_m": point("Green-Lagrange strain tensor, heat not subtracted", (2, 2), "1",
                          lambda at: at.of(at.element.mechanical_strain(at.state.e))),
    "11.S_a": point("e^T S_a e = (J^T J)_11, by polarisation", SQUARE, "1/m^2; slopes 1/m, 1",
                    lambda at: at.polarised(0, 0)),
    "11.S_b": point("e^T S_b e = (J^T J)_22, by polarisation", SQUARE, "1/m^2; slopes 1/m, 1",
                    lambda at: at.polarised(1, 1)),
    "11.S_c": point("e^T S_c e = (J^T J)_12, by polarisation; not symmetric", SQUARE,
                    "1/m^2; slopes 1/m, 1", lambda at: at.polarised(0, 1)),
    "12.epsilon_f": point("the strain tensor as (11, 22, 12)", (3,), "1",
                          lambda at: at.of(at.element.vector(at.element.mechanical_strain(at.state.e)))),
    **{f"13.epsilon_{k + 1}": point(
        f"component {i + 1}{j + 1} of the strain tensor", (), "1",
        lambda at, i=i, j=j: at.of(at.element.mechanical_strain(at.state.e)[i][j]))
       for k, (i, j) in enumerate(((0, 0), (1, 1), (0, 1)))},
    "14.epsilon": point("strain less thermal strain (11, 22, 12)", (3,), "1",
                        lambda at: at.of(at.element.strain_at_state)),
    "15.sigma": point("second Piola-Kirchhoff stress (11, 22, 12); 12 is 2 mu epsilon_3", (3,), "Pa",
                      lambda at: at.stress),
    "16.D": Quantity("elasticity matrix, sigma = D epsilon", (3, 3), "Pa", lambda el: el.D.tolist()),
    "17.lambda": Quantity("first Lame constant", (), "Pa", lambda el: el.lam),
    "17.mu": Quantity("shear modulus", (), "Pa", lambda el: el.mu),
    "18.U": Quantity("strain energy, full tensor contraction", (), "J", lambda el: el.at_state(el.energy)),
    "18.U/printed-shear": Quantity("strain energy of (18) with (16) as printed (E3)", (), "J",
                                   lambda el: el.at_state(el.energy_printed_shear), form="printed"),
    "19.Q_e": Quantity("elastic force dU/de", (DOF,), NODAL_FORCE, lambda el: el.force(el.energy)),
    "19.Q_e/printed-shear": Quantity("dU/de of the printed energy (E3)", (DOF,), NODAL_FORCE,
                                     lambda el: el.force(el.energy_printed_shear), form="printed"),
    "20.K": Quantity("(lambda + 2 mu) K_1 + lambda K_2 + 4 mu K_3; K e = Q_e", SQUARE, NODAL_STIFFNESS,
                     lambda el: el.K(4 * el.mu).tolist()),
    "20.K/printed-shear": Quantity("(20) as printed, 2 mu K_3 (E3), with the consistent K_3", SQUARE,
                                   NODAL_STIFFNESS, lambda el: el.K(2 * el.mu).tolist(), form="printed"),
    **{f"21.K_{m + 1}": Quantity(f"integral of (21) for K_{m + 1}", SQUARE, "m; slopes m^2, m^3",
                                 lambda el, m=m: el.K_parts[m].tolist()) for m in range(3)},
    "21.K_3/printed": Quantity("K_3 as printed, with its -1 and without heat (E2)", SQUARE,
                               "m; slopes m^2, m^3", lambda el: el.K_3_printed.tolist(), form="printed"),
    **{f"21.S_{name}1": point(f"second derivative of e^T S_{name} e", SQUARE, "1/m^2; slopes 1/m, 1",
                              lambda at, k=k: at.form_hessian(k)) for k, name in enumerate("abc")},
    "22.eddot": Quantity("accelerations solving M eddot + Q_e = Q_w under gravity", (DOF,),
                         "m/s^2; slopes 1/s^2", acceleration),
    "22.residual": Quantity("M a + Q_e - Q_w for the acceleration a = edot / (1 s)", (DOF,), NODAL_FORCE, residual),
    "gravity.Q_w": Quantity("derivative of the weight's work", (DOF,), NODAL_FORCE,
                            lambda el: el.gravity_force),
    "tangent.dQ_e": Quantity("second derivative of U", SQUARE, NODAL_STIFFNESS,
                             lambda el: el.tangent(el.energy)),
    "tangent.dQ_e/printed-shear": Quantity("second derivative of the printed energy (E3)", SQUARE,
                                           NODAL_STIFFNESS, lambda el: el.tangent(el.energy_printed_shear),
                                           form="printed"),
    "axis.D_0": Quantity("stress from (11, 22, 2 12) off the axis: diag(E*, E*, mu), E* = E/(1 - nu^2)", (3, 3),
                         "Pa", lambda el: el.D_0.tolist()),
    "axis.epsilon": point("strain less thermal strain (11, 22, 2 12) in the rod's own axes", (3,), "1",
                          lambda at: at.of(at.element.own(at.element.strain(at.state.e)))),
    "axis.U": Quantity("strain energy with Poisson's terms on the axis alone", (), "J",
                       lambda el: el.at_state(el.energy_axis)),
    "axis.Q_e": Quantity("its derivative", (DOF,), NODAL_FORCE, lambda el: el.force(el.energy_axis)),
    "axis.tangent": Quantity("its second derivative", SQUARE, NODAL_STIFFNESS,
                             lambda el: el.tangent(el.energy_axis)),
    "uniaxial.D": Quantity("stress from (11, 22, 2 12) of the uniaxial law: diag(E, E, G), G = E/(2 (1 + nu))", (3, 3),
                           "Pa", lambda el: el.D_uniaxial.tolist()),
    "uniaxial.U": Quantity("strain energy of the uniaxial law", (), "J", lambda el: el.at_state(el.energy_uniaxial)),
    "uniaxial.Q_e": Quantity("its derivative", (DOF,), NODAL_FORCE, lambda el: el.force(el.energy_uniaxial)),
    "uniaxial.tangent": Quantity("its second derivative", SQUARE, NODAL_STIFFNESS,
                                 lambda el: el.tangent(el.energy_uniaxial)),
}
