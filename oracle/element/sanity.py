"""Identities of mechanics that hold in every state, whatever the derivation; asserted before a value is stored."""

from flint import fmpq, fmpq_mat


def demand(state, values):
    """Asserts exact identities between the values of one state."""
    e, edot = column(state.e), column(state.edot)
    M = fmpq_mat(values["7.M"])
    assert values["A.2.e"] == list(state.e), "the field must take the nodal values"
    assert M == M.transpose() and value(edot.transpose() * M * edot) / 2 == values["6.T"]
    # Positions are the vectors 0, 2 and 5 of (4); a translation leaves slopes unchanged.
    shift = column([fmpq(int(k in (0, 4, 10))) for k in range(14)])
    mass = state.rho * state.l * state.h * state.w
    assert value(shift.transpose() * M * shift) == mass, "a translation must move the whole mass"
    weight = values["gravity.Q_w"]
    assert [weight[i] + weight[4 + i] + weight[10 + i] for i in range(2)] == [mass * g for g in state.gravity]
    balance = M * column(values["22.eddot"]) + column(values["19.Q_e"])
    assert balance == column(weight), "(22) must hold"
    for form in ("", "/printed-shear"):
        names = ("18.U", "19.Q_e", "tangent.dQ_e")
        demand_of_force(state, *(values[name + form] for name in names))
        K = fmpq_mat(values["20.K" + form])
        assert K == K.transpose() and K * e == column(values["19.Q_e" + form]), "K(e) e must be the force"
    demand_of_axis(state, values)
    demand_of_uniaxial(state, values)
    for k in range(len(state.points)):
        demand_at_point(state, lambda name, k=k: values[name][k])
    if "rest" in state.tags:
        assert fmpq_mat(values["21.K_3/printed"]) * e != column([fmpq(0)] * 14), "E2 must show at rest"
    if "uniaxial" in state.tags:
        axial = -state.E * state.alpha * state.dT / (1 - state.nu**2)
        c, s = state.direction
        assert values["15.sigma"][0] == [axial * c * c, axial * s * s, axial * c * s]


def demand_of_force(state, energy, force, tangent):
    """Asserts the identities of one form of the energy: symmetric tangent, no resultant, no moment, sign."""
    Q, tangent = column(force), fmpq_mat(tangent)
    assert tangent == tangent.transpose()
    for i in range(2):
        assert force[i] + force[4 + i] + force[10 + i] == 0, "the force must have no resultant"
    turned = column(quarter_turn(state.e))
    assert value(turned.transpose() * Q) == 0, "the force must have no moment"
    at_ease = {"rest", "rigid", "stress-free"} & set(state.tags)
    assert (energy == 0 and not any(force)) if at_ease else energy > 0


def demand_of_axis(state, values):
    """Asserts the identities of the energy with Poisson's terms on the axis: those of any energy, and its relation to 18.U."""
    names = ("U", "Q_e", "tangent")
    axis, full = ([values[name] for name in form] for form in (
        [f"axis.{name}" for name in names], ["18.U", "19.Q_e", "tangent.dQ_e"]))
    demand_of_force(state, *axis)
    turned, turned_force = (column(quarter_turn(vector)) for vector in (state.e, axis[1]))
    assert fmpq_mat(axis[2]) * turned == turned_force, "a turn must turn the force"
    if state.nu == 0:
        assert axis == full, "at nu = 0 both energies must be equal"
    if {"rest", "rigid", "uniform", "stress-free", "blocked", "uniaxial"} & set(state.tags):
        # The gradient is uniform over the element: energy and force are equal, the tangents are not.
        assert axis[:2] == full[:2] and (state.nu == 0 or axis[2] != full[2])
    a = state.alpha * state.dT
    heat = {"none": (0, 0), "1d": (a, 0), "2d": (a, a)}[state.model]
    for k, eps in enumerate(values["axis.epsilon"]):
        r_x, r_y = ([sum(S * q for S, q in zip(values[name][k], state.e[i::2])) for i in range(2)]
                    for name in ("3.S_x", "3.S_y"))
        metric = [sum(u * v for u, v in zip(*pair)) for pair in ((r_x, r_x), (r_y, r_y), (r_x, r_y))]
        assert eps == [(metric[0] - 1) / 2 - heat[0], (metric[1] - 1) / 2 - heat[1], metric[2]]


def demand_of_uniaxial(state, values):
    """Asserts the identities of the uniaxial energy: those of any energy, and its relation to 18.U and to a bar's."""
    names = ("U", "Q_e", "tangent")
    own, full = ([values[name] for name in form] for form in (
        [f"uniaxial.{name}" for name in names], ["18.U", "19.Q_e", "tangent.dQ_e"]))
    demand_of_force(state, *own)
    turned, turned_force = (column(quarter_turn(vector)) for vector in (state.e, own[1]))
    assert fmpq_mat(own[2]) * turned == turned_force, "a turn must turn the force"
    assert state.nu != 0 or own == full, "at nu = 0 both energies must be equal"
    # Any uniform strain: the energy is that of two bars and a shear spring, with the strain at any point.
    if {"rest", "rigid", "uniform", "stress-free", "blocked", "uniaxial"} & set(state.tags):
        along, across, shear = values["axis.epsilon"][0]
        volume, G = state.l * state.h * state.w, values["17.mu"]
        assert own[0] == volume * (state.E * (along**2 + across**2) + G * shear**2) / 2


def demand_at_point(state, at):
    """Asserts the identities of the fields at one material point; `at` returns a quantity by its name."""
    e, e0, edot = map(column, (state.e, state.e0, state.edot))
    assert at("A.1.r") == at("A.4.r") == at("1.r")
    assert fmpq_mat(at("2.S")) * e == column(at("1.r"))
    assert fmpq_mat(at("2.S")) * edot == column(at("5.rdot"))
    slopes = fmpq_mat(at("9.J")) * fmpq_mat(at("9.J_0"))
    for j, name in enumerate(("3.S_x", "3.S_y")):
        for i in range(2):
            assert sum(S * q for S, q in zip(at(name), state.e[i::2])) == slopes[i, j]
    for name, i, j in (("a", 0, 0), ("b", 1, 1), ("c", 0, 1)):
        S = fmpq_mat(at(f"11.S_{name}"))
        assert S + S.transpose() == fmpq_mat(at(f"21.S_{name}1"))
        assert value(e0.transpose() * S * e) == at("9.J")[i][j], "J(e0) must be the identity"
        assert value(e.transpose() * S * e) == 2 * at("10.epsilon_m")[i][j] + int(i == j)


def demand_breadth(states):
    """Asserts the range of the states: sizes, materials, inclinations, both signs of heat in both models."""
    assert len(states) >= 24 and len({state.id for state in states}) == len(states)
    assert {fmpq(0), fmpq(3, 10), fmpq(49, 100)} <= {state.nu for state in states}
    slenderness = {state.l / state.h for state in states}
    assert min(slenderness) == 2 and max(slenderness) == 1000
    inclined = [state for state in states if 0 not in state.direction]
    signs = {(state.model, state.dT > 0) for state in inclined if state.dT != 0}
    assert {(model, sign) for model in ("1d", "2d") for sign in (False, True)} <= signs
    assert any(state.dT == 0 for state in inclined)
    assert any(state.dT != 0 for state in inclined if state.model == "none"), "a state with dT but the model none"
    assert any(state.alpha < 0 for state in inclined if state.model != "none" and state.dT != 0)
    assert any(state.nu < 0 for state in inclined)
    free = {state.model for state in inclined if "stress-free" in state.tags}
    assert free == {"1d", "2d"}, "stress-free states in both models"
    assert all(1 + 2 * state.alpha * state.dT > 0 for state in states)


def quarter_turn(vector):
    """Rate of nodal coordinates in a rotation about the origin with unit angular velocity."""
    return [part for k in range(0, 14, 2) for part in (-vector[k + 1], vector[k])]


def column(vector):
    """A list as a matrix of one column."""
    return fmpq_mat([[entry] for entry in vector])


def value(matrix):
    """The number in a matrix of one entry."""
    return matrix[0, 0]
