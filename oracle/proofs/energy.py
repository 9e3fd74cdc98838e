"""The strain energy (18) and its derivatives (19)-(21)."""

from itertools import product

import sympy
from sympy import Rational, diff, expand, integrate, simplify

from ..element import field
from ..element.element import DOF, Element
from ..element.field import l, x, y
from ..element.state import Q, field_in, make, nodes, scatter, straight
from ..element.states import DOWN_46, EAST, PENDULUM, TABLE_1, states
from ..fixtures.fixture import to_sympy
from .strain import I, R, theta

h, w, lam, mu = sympy.symbols("h w lambda mu", positive=True)


def density(E, shear_weight):
    """Energy density of (18) with a weight for E_12^2/2: 4 mu for the full contraction, 2 mu as printed."""
    same = (lam + 2 * mu) / 2 * (E[0, 0] ** 2 + E[1, 1] ** 2) + lam * E[0, 0] * E[1, 1]
    return same + shear_weight / 2 * E[0, 1] ** 2


def printed_K_3_loads_an_undeformed_element():
    """E2. The force K_3 e with the printed -1 does work in a pure shear of the undeformed element.

    The element is straight at any angle. S_c1 e is the derivative of e^T S_c e = (J^T J)_12. The right force is the
    derivative of the energy's part eps_3^2/2 with eps_3 = (J^T J)_12/2.
    """
    step = sympy.symbols("step")

    def nodal(matrix):
        """Nodal vectors of r = matrix (x, y)."""
        rows = [field.nodal_values(component) for component in matrix * sympy.Matrix([x, y])]
        return [value for pair in zip(*rows) for value in pair]

    e = nodal(R + step * sympy.Matrix([[0, 1], [1, 0]]) * R)
    r = [sum(S * q for S, q in zip(field.shape_functions(), e[i::2])) for i in range(2)]
    J = sympy.Matrix(r).jacobian([x, y]) * R.T
    C_12 = (J.T * J)[0, 1]

    def work(rate):
        at_rest = simplify(rate.subs(step, 0))
        return simplify(w * integrate(at_rest, (y, -h / 2, h / 2), (x, 0, l)))

    assert work(diff((C_12 / 2) ** 2 / 2, step)) == 0
    assert work(diff(C_12, step) * (C_12 - 1) / 4) == -l * h * w / 2
    return "E2: K_3 as printed does the work -l h w/2 in the shear epsilon_12 = 1 of an undeformed element"


def printed_shear_depends_on_the_frame():
    """E3. A rotation of an element with its initial state must not change the energy.

    At any point of any state, let G be dr/d(x, y) with the initial element along the first axis. At the inclination
    theta the gradient is J = R G R^T. As R^T R = I, the strain is R E R^T, as is the thermal strain of either model. The
    result for the density carries over to its integral U.
    """
    assert simplify(R.T * R) == I
    E_11, E_22, E_12 = sympy.symbols("E_11 E_22 E_12")
    own = sympy.Matrix([[E_11, E_12], [E_12, E_22]])
    contraction = sum(
        (lam * I[i, j] * I[k, m] + mu * (I[i, k] * I[j, m] + I[i, m] * I[j, k])) * own[i, j] * own[k, m] / 2
        for i, j, k, m in product(range(2), repeat=4)
    )
    assert expand(contraction - density(own, 4 * mu)) == 0
    E = R * own * R.T
    assert simplify(diff(density(E, 4 * mu), theta)) == 0
    slope = diff(density(E, 2 * mu), theta).subs(theta, 0)
    assert simplify(slope) == 2 * mu * E_12 * (E_22 - E_11)

    energies = []
    for direction in (EAST, DOWN_46):
        stretch = straight(direction, axial=Q(101, 100))
        element = Element(make("", "", "", PENDULUM, direction, stretch, material=TABLE_1))
        pair = (element.energy, element.energy_printed_shear)
        energies.append([element.at_state(energy) for energy in pair])
    (level, level_printed), (inclined, inclined_printed) = energies
    assert level == inclined == level_printed != inclined_printed
    ratio = float(to_sympy(inclined_printed / level_printed))
    return f"E3: with 4 mu dU/dtheta = 0; with 2 mu a stretched rod at -46.4 degrees has {ratio:.4f} of its U"


def printed_shear_softens_an_inclined_rod():
    """E3 at nu = 0: the compliance of a slender rod as a function of its inclination.

    In bending the strain is axial, t t^T, and linear in y over the section. In tension the other two components are
    uniform over the section and take the values of least energy.
    """
    t, n = R[:, 0], R[:, 1]
    across, slip = sympy.symbols("across slip")

    def stiffness(E):
        return 2 * density(E, 2 * mu).subs({lam: 0, mu: Rational(1, 2)})

    bending = simplify(stiffness(t * t.T))
    tension = stiffness(t * t.T + across * n * n.T + slip * (t * n.T + n * t.T))
    least = sympy.solve([diff(tension, across), diff(tension, slip)], [across, slip])
    found = []
    for degrees, in_bending, in_tension in ((45, 1.333, 1.5), (80, 1.030, 1.058)):
        at = {theta: sympy.rad(degrees)}
        pair = [float(1 / k.subs(at)) for k in (bending, tension.subs(least))]
        assert all(abs(a - b) < 6e-4 for a, b in zip(pair, (in_bending, in_tension)))
        found.append(f"{pair[0]:.3f} and {pair[1]:.3f} at {degrees} degrees")
    return "E3: compliance in bending and tension is multiplied by " + ", ".join(found)


def five_by_three_points_are_exact():
    """The integrand of (21) has degree 8 in x and 4 in y for a straight element, level or inclined.

    K_1, K_2 and K_3 are integrals of products of eps_k with the second derivative of eps_n, for these pairs k, n.
    n Gauss points integrate polynomials of degree 2 n - 1 exactly.
    """
    pairs = ((0, 0), (1, 1), (0, 1), (1, 0), (2, 2))
    for direction in (EAST, DOWN_46):
        element = Element(next(state for state in states() if state.direction == direction))
        strains = element.vector(element.generic_strain)
        degrees = [
            (strains[k] * element.strain_hessians[n][i][j]).degrees()[:2]
            for k, n in pairs for i in range(DOF) for j in range(i, DOF)
        ]
        largest = [max(d) for d in zip(*degrees)]
        assert largest == [8, 4]
        points = [next(n for n in range(1, 9) if 2 * n - 1 >= degree) for degree in largest]
        assert points == [5, 3]
    return "the integrand of (21) has degree (8, 4): 5 x 3 Gauss points are exact, fewer are not"


def force_and_tangent_are_differences():
    """Q_e and the tangent equal five-point differences of U, which are exact because U is quartic in e.

    U is integrated by sympy in five numerical states, with the density above. Only the shape functions are shared with
    the polynomials in e that the fixture differentiates.
    """
    state = next(state for state in states() if state.id == "random-bar-2d")
    element = Element(state)
    direction = scatter(99, 8, 8)
    cosine, sine = map(to_sympy, state.direction)
    turn = sympy.Matrix([[cosine, -sine], [sine, cosine]])
    size = {name: to_sympy(getattr(state, name)) for name in ("l", "h", "w", "E", "nu", "alpha", "dT")}
    first = size["E"] * size["nu"] / (1 + size["nu"]) / (1 - 2 * size["nu"])
    shear = size["E"] / (1 + size["nu"]) / 2

    def energy(step, shear_weight):
        e = [to_sympy(q + step * d) for q, d in zip(state.e, direction)]
        shapes = [S.subs(l, size["l"]) for S in field.shape_functions()]
        r = sympy.Matrix([sum(S * q for S, q in zip(shapes, e[i::2])) for i in range(2)])
        J = r.jacobian([x, y]) * turn.T
        E = ((J.T * J - I) / 2 - size["alpha"] * size["dT"] * I).applyfunc(expand)
        W = density(E, shear_weight).subs({lam: first, mu: shear})
        half = size["h"] / 2
        return size["w"] * integrate(integrate(expand(W), (y, -half, half)), (x, 0, size["l"]))

    for shear_weight, polynomial in ((4 * mu, element.energy), (2 * mu, element.energy_printed_shear)):
        U = {step: energy(step, shear_weight) for step in (-2, -1, 0, 1, 2)}
        slope = (U[-2] - 8 * U[-1] + 8 * U[1] - U[2]) / 12
        curvature = (-U[-2] + 16 * U[-1] - 30 * U[0] + 16 * U[1] - U[2]) / 12
        force, tangent = element.force(polynomial), element.tangent(polynomial)
        assert slope == to_sympy(sum(f * d for f, d in zip(force, direction)))
        second = sum(a * k * b for a, row in zip(direction, tangent) for k, b in zip(row, direction))
        assert curvature == to_sympy(second)
    return "Q_e and the tangent are the exact differences of U, integrated a second way"


def poisson_on_the_axis_frees_the_thickness():
    """Second derivative of U in pure bending, where sections rotate and cannot widen on one side.

    For the consistent energy it is (lambda + 2 mu) I l, which is E* I l times (1 - nu)^2/(1 - 2 nu). With Poisson's terms
    on the axis it is E* I l, that of the plane-strain beam. In uniform stretch both energies agree, with the thickness
    held and free.
    """
    state = next(state for state in states() if state.id == "rest-vertical")
    element = Element(state)
    nu, I_l = state.nu, state.w * state.h**3 / 12 * state.l
    plane = state.E / (1 - nu**2)

    def curvature(energy, *own):
        rate = nodes(state.l, field_in(state.direction, (0, 0), *own))
        tangent = element.tangent(energy)
        return sum(a * k * b for a, row in zip(rate, tangent) for k, b in zip(row, rate))

    bend = ((0, 0), (0, 0), (-1, 0), (0, Q(1, 2)))
    assert curvature(element.energy, *bend) == plane * I_l * (1 - nu) ** 2 / (1 - 2 * nu)
    assert curvature(element.energy_axis, *bend) == plane * I_l
    volume, contraction = state.l * state.h * state.w, -nu / (1 - nu)
    for stretch, stiffness in (((1, 0), (0, 0)), element.lam + 2 * element.mu), (((1, 0), (0, contraction)), plane):
        for energy in (element.energy, element.energy_axis):
            assert curvature(energy, *stretch) == stiffness * volume
    ratio = float(to_sympy((1 - nu) ** 2 / (1 - 2 * nu)))
    return f"axis: in bending at nu = 0.3 the consistent element is {ratio:.4f} times too stiff; axis.U is not"


def the_uniaxial_law_is_that_of_a_strut():
    """Second derivative of the uniaxial U at rest: E A l in stretch, E I l in bending, G A l in shear.

    With E I the bending stiffness is 1 - nu^2 of plane strain's (E* I), so that a slender strut deflects 1/(1 - nu^2) times as
    far. A stretch takes no thickening along: the two directions are not coupled.
    """
    state = next(state for state in states() if state.id == "rest-vertical")
    element = Element(state)
    nu, A_l = state.nu, state.w * state.h * state.l
    shear = state.E / (2 * (1 + nu))
    motions = {"stretch": ((1, 0), (0, 0)), "thicken": ((0, 0), (0, 1)), "shear": ((0, 1), (0, 0)),
               "bend": ((0, 0), (0, 0), (-1, 0), (0, Q(1, 2)))}
    expected = {"stretch": state.E * A_l, "thicken": state.E * A_l, "shear": shear * A_l,
                "bend": state.E * A_l * state.h**2 / 12}
    tangent = element.tangent(element.energy_uniaxial)
    rates = {name: nodes(state.l, field_in(state.direction, (0, 0), *own)) for name, own in motions.items()}
    for one, a in rates.items():
        for other, b in rates.items():
            found = sum(u * k * v for u, row in zip(a, tangent) for k, v in zip(row, b))
            assert found == (expected[one] if one == other else 0), (one, other)
    ratio = float(to_sympy(1 / (1 - nu**2)))
    return f"uniaxial: E A, E I and G A of a strut; it bends {ratio:.4f} times as far as plane strain at nu = {float(to_sympy(nu))}"
