"""(18)-(21): from the energy to forces."""

import sympy

from ..element import field
from . import symbols as Y
from .algebra import GEN, NODAL, Matrix, column, normal, over_volume, replace, total
from .calculus import Derivative, Each, Evaluated, Function, Integral, Total
from .inertia import MOVE
from .material import LAMBDA, MU, lambda_of, mu_of, nu
from .notation import PRODUCT, Grouped, Quotient, Symbol, node
from .symbols import (EPS, HALF, PLANE, S_a, S_a1, S_b, S_b1, S_c, S_c1, SIGMA, SQUARES, bar_1, bar_2, bar_3, e, e_0, energy,
                      eps, eps_1, eps_2, eps_3, heat, lam, mu, sigma, sigma_1, sigma_2, sigma_3, theta)

quarter, half = node("1/4"), node("1/2")


def virtual_work():
    """Q_e from the principle of virtual work: first Piola-Kirchhoff stress times the rates of J."""
    stress = Y.tensor(SIGMA)
    first = Y.J.meaning @ stress
    return [normal(over_volume(total(first[i, k] * rate[i, k] for i in PLANE for k in PLANE)))
            for rate in Y.columns_of_J()]


def weighted(weights):
    """The integral of sum_k weights_k d2(eps_k)/de de, a symmetric matrix."""
    pairs = [(weight, H) for weight, H in zip(weights, SQUARES) if weight is not None]
    rows = [[Y.ZERO] * 14 for _ in range(14)]
    for i in range(14):
        for j in range(i, 14):
            density = total(weight * H[i, j] * HALF for weight, H in pairs)
            rows[i][j] = rows[j][i] = normal(over_volume(density))
    return Matrix(rows)


U = Symbol("U", energy())
Q_e = Symbol(r"\mathbf Q_e", column(virtual_work()))
# Stresses of the three parts of the energy density times the second derivatives of the strains.
K_1 = Symbol(r"\mathbf K_1", weighted((EPS[0], EPS[1], None)))
K_2 = Symbol(r"\mathbf K_2", weighted((EPS[1], EPS[0], None)))
K_3 = Symbol(r"\mathbf K_3", weighted((None, None, EPS[2])))
K = Symbol(r"\mathbf K", weighted((SIGMA[0], SIGMA[1], 2 * SIGMA[2])))
U_printed = Symbol(r"U_\text{printed}", normal(over_volume(total(a * b for a, b in zip(EPS, SIGMA)) * HALF)))


def turned_strain(angle, own):
    """Components 11, 22 and 12 of a strain in a frame rotated by an angle."""
    R = sympy.Matrix([[sympy.cos(angle), -sympy.sin(angle)], [sympy.sin(angle), sympy.cos(angle)]])
    E = R * sympy.Matrix([[own[0], own[2]], [own[2], own[1]]]) * R.T
    return E[0, 0], E[1, 1], E[0, 1]


def frame():
    """Energy density with a weight for the shear, of a strain given in the rod's own axes, in a frame rotated by theta."""
    angle = sympy.Symbol("theta", real=True)
    own = sympy.symbols("E_11 E_22 E_12", real=True)
    first, second = LAMBDA, MU
    along, across, shear = turned_strain(angle, own)

    def density(weight):
        return (first + 2 * second) / 2 * (along**2 + across**2) + first * along * across + weight * second / 2 * shear**2

    return angle, own, density


def write(page):
    """The chapter."""
    page.heading("5 Energy and forces")
    page.section("18", "Strain energy", ["equations.force::U", "equations.force::U_printed"])
    page.words("""Half of stress times strain, summed over all components and all points. The shear stress works on
        two components, 12 and 21, which are equal; hence the 2:""")
    page.formula(U, half * Integral("V", bar_1 * sigma_1 + bar_2 * sigma_2 + 2 * bar_3 * sigma_3), number="18",
                 how="""The left side is the contraction over all four components in the rod's own axes, where no
        inclination enters; the right side is in global axes, with the strains (14) and the stresses (15).""")
    page.words("""With the stresses (15) put in, it is""")
    page.formula(U, half * Integral("V", (lam + 2 * mu) * (bar_1**2 + bar_2**2) + 2 * lam * bar_1 * bar_2 + 4 * mu * bar_3**2),
                 how="As above.")
    page.words("""**E3, an error in the paper.** It prints the product of the two columns, which counts the shear
        once:""")
    page.formula(U_printed, half * Integral("V", eps.T * sigma), U - Integral("V", mu * bar_3**2),
                 how="The left side is summed strain by strain.")
    angle, own, density = frame()
    psi = Symbol(r"\psi", density(4))
    psi_printed = Symbol(r"\psi_\text{printed}", density(2))
    E_11, E_22, E_12 = (Symbol(rf"\varepsilon_{{{n}}}", symbol) for n, symbol in zip(("tt", "nn", "tn"), own))
    page.words("""This is no matter of taste, because a body's energy must not depend on who looks. Take one strain,
        given in the rod's own axes as {tt}, {nn} and {tn}, and describe it from a frame turned by {phi}. With the 2, the
        density {psi} of the energy does not change; without it, it does. The components turn as those of any tensor:""",
               phi=PHI, psi=psi, tt=E_11, nn=E_22, tn=E_12)
    turning = {rf"\{name}": Symbol(rf"\{name}\varphi", function(angle)) for name, function in (("cos", sympy.cos), ("sin", sympy.sin))}
    C, S = (Function(name, PHI, turning) for name in turning)
    first, second, third = (Symbol(f"\\varepsilon_{k}", value) for k, value in enumerate(turned_strain(angle, own), 1))
    page.formulas_of([
        (first, E_11 * C**2 + E_22 * S**2 - 2 * E_12 * S * C), (second, E_11 * S**2 + E_22 * C**2 + 2 * E_12 * S * C),
        (third, (E_11 - E_22) * S * C + E_12 * (C**2 - S**2)),
        (psi, half * (lambda_of + 2 * mu_of) * (first**2 + second**2) + lambda_of * first * second + 2 * mu_of * third**2),
        (psi_printed, psi - mu_of * third**2)],
        how="The strains are the product of the rotation matrix, the tensor and the transpose; the densities are computed with them.")
    page.words("""The first two squares gain, in a turn, what the third loses twice. Differentiate, and take the frame along the rod:""")

    def slope(symbol):
        return Derivative(symbol, PHI.text, [angle])

    turn = Symbol(PHI.text, angle)
    page.formulas_of([(slope(psi), node(0)),
                      (Evaluated(slope(psi_printed), turn, 0), 2 * mu_of * E_12 * (E_22 - E_11))], blind=(f"2 {psi.text}",),
                     how="The left sides are derivatives of the densities of a strain turned by the rotation matrix.")
    cos, sin = Symbol(r"\cos\theta", sympy.cos(angle)), Symbol(r"\sin\theta", sympy.sin(angle))
    bending, tension = softening(own, density)
    page.figure("frame", """A rod that is stretched, its transverse strain zero, seen from a frame turned against it: the
        energy density over its true value, printed and right""")
    page.words("""What it does to a slender rod of the inclination {theta} whose {nu} is zero, beside the right one: its stiffness {B} in bending,
        and its compliance {C} in tension, get the factors""", theta=theta, nu=Symbol(r"\nu", 0), B=Symbol("B", 0), C=Symbol("C", 0))
    page.formulas_of([
        (Quotient(*(Symbol(text, value) for text, value in zip((r"B_\text{printed}", "B"), bending))), 1 - square(sin) * square(cos)),
        (Quotient(*(Symbol(text, value) for text, value in zip((r"C_\text{printed}", "C"), tension))), 1 + 2 * square(sin) * square(cos))],
        how="""Bending: the density of an axial strain alone. Tension: the axial strain is given and the other two
        take the values of least energy.""")
    page.words("""A rod at 45 degrees loses a quarter of its stiffness in bending and a third in tension, one along
        an axis none. Rods of a deployable structure are inclined. Everything in this project but what has *printed*
        in its name uses (18) as it stands here.""")

    page.exercise("A rod at 45 degrees is pulled, and free to shear. By which factor is it too soft with the printed energy?", "7-errata")

    page.section("19", "Elastic forces", ["equations.force::Q_e"])
    page.words("""If the nodal coordinates change a little, the energy changes; its derivative is the force against
        that change. **In indices.** {W} is quadratic in the strains, so its derivative by one coordinate {e_n} is a
        sum over the strains, by the chain rule; the derivative of the energy density by a strain is its stress, the shear
        counted twice. Heat does not depend on {e_n}, so the strains (13) take the place of those less heat:""",
               W=U, e_n=Symbol("e_n", 0))
    page.formula(Each(lambda n: by(U, n), index="n", last=14),
                 Each(lambda n: Integral("V", sigma_1 * by(eps_1, n) + sigma_2 * by(eps_2, n) + 2 * sigma_3 * by(eps_3, n)),
                      index="n", last=14),
                 how="For all 14 coordinates; the left side is differentiated from the energy (18).")
    page.words("""A strain is a double sum over coordinates, in which {e_n} stands twice, as first factor and as second:""", e_n=Symbol("e_n", 0))
    page.formula(Each(lambda n: by(eps_1, n), index="n", last=14),
                 Each(lambda n: half * Total(lambda m: (entry("a", n, m) + entry("a", m, n)) * coordinate(m), index="m", last=14),
                      index="n", last=14),
                 how="For all 14 coordinates; the left side is differentiated from the strain (13).")
    page.words("""**In matrices.** The derivative of a quadratic form takes the matrix and its transpose. With the names""")
    page.formulas_of([(S_a1, S_a.T + S_a), (S_b1, S_b.T + S_b), (S_c1, S_c.T + S_c)],
                     how="The left sides are second derivatives of the metric by the nodal coordinates.",
                     blind=(rf"no transpose of {S_a.text}", rf"no transpose of {S_b.text}"))
    page.words("""the derivatives of the three strains by {e} are the rows""", e=e)
    page.formulas_of([(Derivative(eps_n, r"\mathbf e", NODAL), half * e.T * S_n1)
                      for eps_n, S_n1 in ((eps_1, S_a1), (eps_2, S_b1), (eps_3, S_c1))],
                     how="The left sides are differentiated from the strains (13).")
    page.words("""Put into the sum above, {eT} is a factor on the left of all, and can be taken out of the integral. What is left is a
        matrix {K}, which depends on {e} through the stresses:""", eT=e.T, e=e, K=K)
    page.formula(Q_e.T, Derivative(U, r"\mathbf e", NODAL), e.T * K, number="19",
                 how="""The left side is the work of the first Piola-Kirchhoff stress on the rates of the gradient,
        the principle of virtual work; no energy is differentiated for it.""")
    page.formula(K, half * Integral("V", sigma_1 * S_a1 + sigma_2 * S_b1 + 2 * sigma_3 * S_c1),
                 how="The left side is the integral of each stress times the second derivatives of its strain, the shear counted twice.")
    page.words("""No force acts where nothing is strained, and forces inside a body have no resultant: moving all
        positions along {d} does no work.""", d=MOVE)
    page.formula(MOVE.T * Q_e, node(0),
                 how="The force is that of virtual work.", blind=(f"2 {MOVE.text}", r"2 \mathbf Q_e"))

    page.section("20", "The stiffness matrix", ["equations.force::K", "equations.force::K_printed"])
    page.words("""Put the stresses (15) into {K} and sort by {first}, {second} and {third}:""", K=K, first=lam + 2 * mu, second=lam, third=mu)
    page.formula(K, (lam + 2 * mu) * K_1 + lam * K_2 + 4 * mu * K_3, number="20",
                 how="""The matrices on the right are integrals for the three parts of the energy alone.""")
    page.words("""The paper prints a 2 in the place of the 4: E3 once more.""")

    page.section("21", "Its parts", ["equations.force::S_1", "equations.force::K_1", "equations.force::K_2",
                                     "equations.force::K_3", "equations.force::K_3_printed"])
    page.words("""Each strain is half of a form less one and less twice its thermal strain, which gives a second half:""")
    a_, b_, c_ = (e.T * S_n * e for S_n in (S_a, S_b, S_c))
    page.formulas_of([
        (K_1, quarter * Integral("V", S_a1 * (a_ - 1 - 2 * heat) + S_b1 * (b_ - 1 - 2 * heat))),
        (K_2, quarter * Integral("V", S_a1 * (b_ - 1 - 2 * heat) + S_b1 * (a_ - 1 - 2 * heat))),
        (K_3, quarter * Integral("V", S_c1 * Grouped(c_)))],
        number="21", how="The left sides are integrals of the strains (14) and of second derivatives.")
    page.words("""**E2, an error in the paper.** It prints a 1 taken off in the last line too, as if the shear had
        the 1 of the normal strains. The force of that term on the element that nobody has touched, cold and at
        rest, does work in the shear {shear} of unit size; the right one does none:""", shear=SHEAR)
    K_3_printed = Symbol(r"\mathbf K_{3,\text{printed}}", weighted((None, None, EPS[2] - HALF)))
    cold_e0 = {"heat": Y.ZERO, **{name: entry for name, (entry,) in zip(NODAL, e_0.meaning.rows)}}
    K_3_rest = Symbol(r"\mathbf K_3(\mathbf e_0)", K_3.meaning.each(lambda entry: normal(replace(entry, **cold_e0))))
    K_3_rest_printed = Symbol(r"\mathbf K_{3,\text{printed}}(\mathbf e_0)",
                              K_3_printed.meaning.each(lambda entry: normal(replace(entry, **cold_e0))))
    page.formulas_of([
        (K_3_printed, quarter * Integral("V", S_c1 * (c_ - 1))),
        (SHEAR.T * K_3_rest_printed * e_0, -(half * Y.l * Y.h * Y.w)),
        (SHEAR.T * K_3_rest * e_0, node(0))],
        how="""The first left side is summed from strains; the others are products of matrices at the nodal
        coordinates of the straight element at any inclination.""", blind=(f"2 {SHEAR.text}", r"2 \mathbf e_0", r"2 \mathbf K_3(\mathbf e_0)"))
    page.words("""With it an element lying on a table would start to shear by itself.""")
    page.words("""With heat along the axis only ([M7](#m7-one-dimensional-heat-has-a-direction)) each bracket of
        (21) loses twice its own component of the thermal strain, the third one too.""")


def by(function, n):
    """Derivative of a polynomial by the nodal coordinate n; n is a number, or the letter that is printed."""
    meaning = function.meaning.derivative(NODAL[n - 1]) if isinstance(n, int) else None
    return Symbol(rf"\frac{{\partial {function.text}}}{{\partial e_{n}}}", meaning, PRODUCT)


def coordinate(m):
    """Nodal coordinate m."""
    return Symbol(f"e_{m}", GEN[NODAL[m - 1]] if isinstance(m, int) else None)


def entry(name, n, m):
    """Entry of S_a, S_b or S_c in row n and column m."""
    meaning = {"a": S_a, "b": S_b, "c": S_c}[name].meaning[n - 1, m - 1] if isinstance(n, int) and isinstance(m, int) else None
    return Symbol(rf"S_{{{name},{n}{m}}}", meaning)


def square(symbol):
    """The square of a sine or a cosine."""
    name = symbol.text.split(r"\theta")[0]
    return Symbol(rf"{name}^2\theta", symbol.meaning**2)


def softening(own, density):
    """Bending stiffness and tensile compliance of a slender rod at nu = 0, each with the printed and the right shear."""
    E_11, E_22, E_12 = own
    value = {nu.meaning: 0}

    def stiffness(weight, strain):
        return sympy.simplify(2 * density(weight).subs(value).subs(strain))

    axial = {E_11: 1, E_22: 0, E_12: 0}
    bending = stiffness(2, axial), stiffness(4, axial)
    free = [density(weight).subs(value).subs(E_11, 1) * 2 for weight in (2, 4)]
    least = [form.subs(sympy.solve([form.diff(E_22), form.diff(E_12)], [E_22, E_12])) for form in free]
    return bending, [sympy.simplify(1 / form) for form in least]


def shear_of_unit_size():
    """Nodal coordinates of the displacement with the initial strain E_12 = 1 in global axes."""
    c, s = sympy.symbols("c s")
    # The displacement (r_0y, r_0x) of the point r_0 = R (x, y): its gradient by r_0 is [[0, 1], [1, 0]].
    fields = (s * field.x + c * field.y, c * field.x - s * field.y)
    values = zip(*[field.nodal_values(component) for component in fields])
    return column([Y.lift(value, (field.l, c, s)) for pair in values for value in pair])


SHEAR = Symbol(r"\mathbf u_\text{shear}", shear_of_unit_size())
PHI = Symbol(r"\varphi", 0)
