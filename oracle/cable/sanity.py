"""Identities of every cable state, computed without `element.py`; asserted before a value is stored.

The energy is computed a second time: axis in Bezier form, Gauss points in closed form, and U along a line e + t d as a
truncated power series in t, whose coefficients are U, Q_e . d and d . K d / 2.
"""

from itertools import combinations_with_replacement

from flint import arb, arb_series, fmpq, fmpq_mat

from .ball import agree

DOF = 8

# Textbook matrices of a straight element in (position, slope) at both ends, without powers of l: bending times EI/l^3, and
# integrals of products of slopes times 1/(30 l).
BENDING = ((12, 6, -12, 6), (6, 4, -6, 2), (-12, -6, 12, -6), (6, 2, -6, 4))
STRETCH = ((36, 3, -36, 3), (3, 4, -3, -1), (-36, -3, 36, -3), (3, -1, -3, 4))


def demand(state, values):
    """Asserts the identities of one state; `values` has the quantities by name, without "cable."."""
    demand_of_inertia(state, values)
    demand_of_points(state, values)
    U, Q, K = (values[name] for name in ("U", "Q_e", "tangent"))
    demand_of_jets(state, U, Q, K)
    demand_of_symmetry(state, Q, K)
    tags = set(state.tags)
    if {"rest", "rigid", "stress-free"} & tags:
        assert U == 0 and not any(Q), "no force without strain"
        assert not any(values["epsilon"] + values["kappa"])
    else:
        assert U > 0
    if {"rest", "rigid", "blocked"} & tags:
        assert K == textbook_tangent(state)
    if {"rest", "rigid", "stress-free", "blocked", "even"} & tags:
        # Energy of a bar, and the work of its force in a stretch proportional to e.
        stretch = sum(g * g for g in state.e[2:4]).sqrt()
        strain = stretch - 1 - heat(state)
        EA = state.E * state.h * state.w
        assert U == EA * state.l * strain**2 / 2
        assert dot(Q, state.e) == EA * state.l * stretch * strain


def heat(state):
    """Thermal strain of the axis."""
    return state.alpha * state.dT * int(state.model in ("1d", "2d"))


def dot(a, b):
    """The scalar product."""
    return sum(u * v for u, v in zip(a, b, strict=True))


def demand_of_inertia(state, values):
    """Asserts the identities of M, T, Q_w and the accelerations."""
    M = values["M"]
    assert M == [list(row) for row in zip(*M)]
    assert dot(state.edot, [dot(row, state.edot) for row in M]) / 2 == values["T"]
    assert values["T"] >= 0 and fmpq_mat(M).det() > 0
    mass = state.rho * state.l * state.h * state.w
    shift = [fmpq(int(k in (0, 4))) for k in range(DOF)]
    assert dot(shift, [dot(row, shift) for row in M]) == mass, "a translation must move the whole mass"
    weight = values["Q_w"]
    assert [weight[i] + weight[4 + i] for i in range(2)] == [mass * g for g in state.gravity]
    # Rotation about node i, r = x n: moment of inertia, and moment of the weight.
    turn = [0, 0, 0, fmpq(1), 0, state.l, 0, fmpq(1)]
    assert dot(turn, [dot(row, turn) for row in M]) == mass * state.l**2 / 3
    assert dot(turn, weight) == mass * state.l / 2 * state.gravity[1]
    for row, Q, w in zip(M, values["Q_e"], weight):
        size = sum(abs_of(m) * abs_of(a) for m, a in zip(row, values["eddot"]))
        assert agree(dot(row, values["eddot"]) + Q, w, size)


def demand_of_points(state, values):
    """Asserts shape functions, positions and strains at the state's points against the Bezier form."""
    units = [[fmpq(int(k == n)) for k in range(DOF)] for n in range(0, DOF, 2)]
    for k, (x, _) in enumerate(state.points):
        for name, order in (("", 0), ("_x", 1), ("_xx", 2)):
            assert values["r" + name][k] == bezier(state.l, state.e, x, order)
            assert values["S" + name][k] == [bezier(state.l, unit, x, order)[0] for unit in units]
        g, c = (bezier(state.l, state.e, x, order) for order in (1, 2))
        square = dot(g, g)
        assert values["kappa"][k] == (g[0] * c[1] - g[1] * c[0]) / square
        assert agree((values["epsilon"][k] + 1 + heat(state)) ** 2, square)


def bezier(l, e, x, order):
    """r, r_x or r_xx at x from the control polygon of the cubic."""
    third = l / 3
    polygons = []
    for i in range(2):
        r_i, r_x_i, r_k, r_x_k = e[i::2]
        points = [r_i, r_i + third * r_x_i, r_k - third * r_x_k, r_k]
        for degree in range(3, 3 - order, -1):
            points = [(b - a) * degree / l for a, b in zip(points, points[1:])]
        while len(points) > 1:
            points = [a + (b - a) * (x / l) for a, b in zip(points, points[1:])]
        polygons.append(points[0])
    return polygons


def closed_gauss(points):
    """Pairs (place, weight) of the Gauss rule on -1 ... 1 in closed form."""
    if points == 3:
        far = (arb(3) / 5).sqrt()
        return [(arb(0), fmpq(8, 9)), (far, fmpq(5, 9)), (-far, fmpq(5, 9))]
    root, seventy = (arb(10) / 7).sqrt(), arb(70).sqrt()
    near, far = ((5 - 2 * root).sqrt() / 3, (5 + 2 * root).sqrt() / 3)
    heavy, light = ((322 + 13 * seventy) / 900, (322 - 13 * seventy) / 900)
    return [(arb(0), fmpq(128, 225)), (near, heavy), (-near, heavy), (far, light), (-far, light)]


def jet(state, direction):
    """U, its first derivative and half its second derivative along a line through e, as balls."""
    e = [arb_series([q, d], prec=3) for q, d in zip(state.e, direction)]
    total = arb_series([0], prec=3)
    for points, stiffness in ((5, state.E * state.h * state.w), (3, state.E * state.w * state.h**3 / 12)):
        for place, weight in closed_gauss(points):
            x = state.l * (1 + place) / 2
            g, c = bezier(state.l, e, x, 1), bezier(state.l, e, x, 2)
            square = dot(g, g)
            strain = square.sqrt() - 1 - heat(state) if points == 5 else (g[0] * c[1] - g[1] * c[0]) / square
            total += strain * strain * (stiffness * weight * state.l / 4)
    return [total[n] for n in range(3)]


def demand_of_jets(state, U, Q, K):
    """Asserts Q_e and the tangent against derivatives of U in all directions of one or two coordinates."""
    units = [[fmpq(int(k == n)) for k in range(DOF)] for n in range(DOF)]
    singles = [jet(state, unit) for unit in units]
    # A ball around zero must be tiny relative to these sizes.
    force = max(abs_of(slope) for _, slope, _ in singles) + abs_of(state.E * state.h * state.w)
    stiffness = max(abs_of(K[n][n]) for n in range(DOF))
    for i, j in combinations_with_replacement(range(DOF), 2):
        if i == j:
            value, slope, curvature = singles[i]
            assert agree(value, U, force) and agree(slope, Q[i], force)
            assert agree(2 * curvature, K[i][i], stiffness)
        else:
            _, _, both = jet(state, [a + b for a, b in zip(units[i], units[j])])
            mixed = both - singles[i][2] - singles[j][2]
            assert agree(mixed, K[i][j], stiffness) and agree(mixed, K[j][i], stiffness)


def demand_of_symmetry(state, Q, K):
    """Asserts that translations and rotations do no work, and that the force rotates with the element."""
    force = max(map(abs_of, Q)) + abs_of(state.E * state.h * state.w)
    for i in range(2):
        assert agree(Q[i] + Q[4 + i], 0, force), "the force must have no resultant"
        assert all(agree(row[i] + row[4 + i], 0, abs_of(row[i])) for row in K)
    e, turned_force = quarter_turn(state.e), quarter_turn(Q)
    assert agree(dot(Q, e), 0, force), "the force must have no moment"
    stiffness = max(abs_of(entry) for row in K for entry in row)
    assert all(agree(dot(row, e), F, stiffness + force) for row, F in zip(K, turned_force))


def quarter_turn(vector):
    """Rate of eight coordinates in a rotation about the origin with unit angular velocity."""
    return [part for k in range(0, DOF, 2) for part in (-vector[k + 1], vector[k])]


def textbook_tangent(state):
    """Tangent of a straight unstretched element at any inclination, under the axial force N = -EA alpha dT."""
    t = state.e[2:4]
    n = (-t[1], t[0])
    l, EA, EI = state.l, state.E * state.h * state.w, state.E * state.w * state.h**3 / 12
    N = -EA * heat(state)
    matrix = []
    for a in range(DOF):
        row = []
        for b in range(DOF):
            (i, p), (j, q) = divmod(a, 2), divmod(b, 2)
            scale = l ** (i % 2 + j % 2)
            stretch, bending = STRETCH[i][j] * scale / (30 * l), BENDING[i][j] * scale / l**3
            row.append(EA * stretch * t[p] * t[q] + (EI * bending + N * stretch) * n[p] * n[q])
        matrix.append(row)
    return matrix


def abs_of(number):
    """Approximate absolute value of a rational number or a ball."""
    return abs(float(arb(number).mid()))


def demand_of_all(states, values):
    """Asserts the range of the states, and that the models 1d and 2d give the same values."""
    assert len(states) >= 20 and len({state.id for state in states}) == len(states)
    assert {fmpq(0), fmpq(3, 10), fmpq(49, 100)} <= {state.nu for state in states}
    assert max(state.l / state.h for state in states) == 1000
    inclined = [state for state in states if 0 not in state.direction]
    assert {("1d", True), ("1d", False), ("2d", True), ("2d", False)} <= {
        (state.model, state.dT > 0) for state in inclined}
    assert {state.model for state in states if state.dT != 0} == {"none", "1d", "2d"}
    assert any(state.alpha < 0 for state in inclined if state.model != "none" and state.dT != 0)
    named = {state.id: found for state, found in zip(states, values, strict=True)}
    one, two = (named[f"bending-inclined-{model}"] for model in ("1d", "2d"))
    for name in one:
        assert str(one[name]) == str(two[name]), "the models 1d and 2d must agree on an axis"
