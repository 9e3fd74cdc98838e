"""M1-M8: choices of the paper that it does not mention."""

import sympy

from ..element import field
from . import symbols as Y
from .algebra import GEN, column, normal
from .calculus import Along, Integral, Root
from .material import E, LAMBDA, MU, lambda_of, mu_of, nu
from .notation import POWER, PRODUCT, Grouped, Power, Quotient, Symbol, Table, node
from .strain import turned
from .symbols import cosine, h, heat, l, lam, mu, sine, w, y
from .tangent import TANGENT

half = node("1/2")
LENGTH, BETA, HEIGHT, WIDTH = (Symbol(text, sympy.Symbol(name, positive=True)) for text, name in
                               (("l", "l"), (r"\beta", "beta"), ("h", "h"), ("w", "w")))
XI = Symbol(r"\hat x", sympy.Symbol("xi"))
PENDULUM = sympy.Rational(285, 10**7) * 200  # the thermal strain of Section 3
a = Symbol(r"\alpha_T \Delta T", sympy.Symbol("a", positive=True), PRODUCT)


def expansion(out_of_plane):
    """In-plane strain of a body that is free in the plane and held across it; `out_of_plane` scales its thermal strain there."""
    free = sympy.Symbol("free")
    elastic, across = free - a.meaning, -out_of_plane * a.meaning
    stress = LAMBDA * (2 * elastic + across) + 2 * MU * elastic
    return sympy.simplify(sympy.solve(stress, free)[0])


def held():
    """Axial stress and squared stretch across of a bar of fixed length, in the models "2d" and "1d"."""
    results = []
    for across_heat in (a.meaning, 0):
        across = sympy.Symbol("across")
        along = -a.meaning
        free = across - across_heat
        solution = sympy.solve(LAMBDA * (along + free) + 2 * MU * free, across)[0]
        stress = LAMBDA * (along + solution - across_heat) + 2 * MU * along
        results.append((sympy.simplify(stress), sympy.simplify(1 + 2 * solution)))
    return results


def nodal_rate(*own):
    """Nodal coordinates of a field given in the rod's own axes."""
    c, s = sympy.symbols("c s")
    turned_field = (c * own[0] - s * own[1], s * own[0] + c * own[1])
    values = zip(*[field.nodal_values(component) for component in turned_field])
    return column([Y.lift(value, (field.l, c, s)) for pair in values for value in pair])


def membrane():
    """Slope u' of the cubic u that minimises the integral of (u' + v'^2/2)^2, with v' = beta xi^2/2."""
    length, beta, xi = LENGTH.meaning, BETA.meaning, XI.meaning
    slopes = sympy.symbols("u_0:3")
    slope = sum(u * xi**k for k, u in enumerate(slopes))
    energy = sympy.integrate(sympy.expand((slope + (beta * xi**2 / 2) ** 2 / 2) ** 2), (xi, -length / 2, length / 2))
    return slope.subs(sympy.solve([energy.diff(u) for u in slopes], slopes))


def write(page):
    """The chapter."""
    page.heading("7 Choices to know")
    page.words("""None of these is an error. Each is a decision that the paper takes without saying so, and that
        shows in numbers.""")

    page.section("", "M1 Plane strain, but heat in the plane only")
    page.words("""(16) is the law of a body that cannot move across the plane, but (8) has no heat across it. So
        nothing presses in that direction, and a free body grows in the plane by {heat}. A body in true plane strain
        is heated in three directions, held in one, and grows more in the other two. At {zero}, the paper's value,
        the two are the same.""", heat=heat, zero=Symbol(r"\nu = 0", 0))
    page.formulas_of([(Symbol(r"\varepsilon_\text{paper}", expansion(0)), a),
                      (Symbol(r"\varepsilon_\text{plane strain}", expansion(1)), (1 + nu) * a)],
                     how="The left sides solve Hooke's law in three dimensions for no stress in the plane.")

    page.section("", "M2 The stress-free stretch is a root")
    page.words("""Heat is taken off a strain that measures squares. A free body's stretch {stretch} is therefore""", stretch=Symbol(r"\Lambda", 0))
    stretch = sympy.Symbol("stretch", positive=True)
    solved = sympy.solve((stretch**2 - 1) / 2 - a.meaning, stretch)
    page.formula(Symbol(r"\Lambda", solved[0]), Root(1 + 2 * a),
                 how="The left side is the positive stretch at which the strain (14) of a free body is zero.")
    page.words("and not one plus the thermal strain, at which a strain of second order would be left:")
    page.formula(half * ((1 + a)**2 - 1) - a, half * a**2, how="Both sides are computed.")
    excess = float(1 + PENDULUM - (1 + 2 * PENDULUM) ** sympy.Rational(1, 2)) * 1e6
    page.words(f"""The two stretches differ by {excess:.0f} millionths for the paper's pendulum at 200 K. The
        radicand must stay positive: scenes that cool further are refused.""")

    page.exercise("A free rod of one metre is 200 K warmer. Where is its end?", "5-heat")

    page.section("", "M3 Free of locking only without Poisson's ratio")
    page.words("""Bend the element at rest to the unit curvature: fibres above the axis shorten, those below
        stretch, in proportion to {y}. They want to grow and shrink across, in proportion to {y} too, but {r_y} is
        one vector for the whole section. So the full plane-strain modulus resists, where a beam has a smaller one:""", y=y, r_y=Symbol(r"\mathbf r_y", 0))
    bend = Symbol(r"\mathbf u_\text{bend}", nodal_rate(-field.x * field.y, field.x**2 / 2))
    tangent = Symbol(r"\frac{\partial \mathbf Q_e}{\partial \mathbf e}(\mathbf e_0)", TANGENT, PRODUCT)
    page.formula(bend.T * tangent * bend, (lam + 2 * mu) * l * Quotient(w * h**3, node(12)),
                 how="""The left side is the second derivative of the energy, at any inclination, along the nodal
        coordinates of such a bending.""")
    page.words("The deflection of a slender beam comes out too small by the ratio of the moduli, whatever the mesh:")
    page.formula(Quotient(Quotient(E, 1 - nu**2), lambda_of + 2 * mu_of), Quotient(1 - 2 * nu, (1 - nu)**2),
                 how="Both sides are computed; the constants on the left are those derived in (17).")
    page.words("""It is one at {zero}. The remedy, an option here, lets Poisson's terms act on the axis alone
        ([`axis`](../src/equations/axis.rs)). The rod is then a strip of a wide plate, held across the plane.""",
               zero=Symbol(r"\nu = 0", 0))
    page.words("""A strut is not held: its sides are free, and its fibres resist with Young's modulus alone. Another
        option, the *uniaxial* law ([`uniaxial`](../src/equations/uniaxial.rs)), gives this modulus to both directions
        of the rod's own axes, without Poisson's contraction, and the shear modulus to the angle between them. It
        does not lock. A slender rod deflects less in plane strain than by this law, and less still in the element
        of the paper, by the ratios""")
    page.formulas_of([(Quotient(E, Quotient(E, 1 - nu**2)), 1 - nu**2),
                      (Quotient(E, lambda_of + 2 * mu_of), Quotient((1 + nu) * (1 - 2 * nu), 1 - nu))],
                     how="All sides are computed; the constants on the left are those derived in (17).")

    page.exercise("A cantilever has Poisson's ratio 0.3. Which deflection will the element have, and which should it?", "6-locking")

    page.section("", "M4 Slender rods in large bending converge slowly")
    page.words("""A slender rod bends without stretching: the axis has to shorten along the chord as it deflects.
        Let the curvature grow linearly in an element, with the rate {beta}, and let {xi} be the distance from its
        middle. The deflection {v} has the slope and the curvature""",
               beta=BETA, xi=XI, v=Symbol("v", 0))
    deflection = BETA.meaning * XI.meaning**3 / 6
    v_x = Symbol("v'", deflection.diff(XI.meaning), POWER)
    v_xx = Symbol("v''", deflection.diff(XI.meaning, 2), POWER)
    u_x = Symbol("u'", membrane(), POWER)
    page.formulas_of([(v_x, half * BETA * XI**2), (v_xx, BETA * XI)],
                     how="The left sides are derivatives of a cubic.")
    page.words("""The shortening that this needs, half the square of the slope, is of degree four in {xi}, and the
        slope {u} of the cubic displacement along the axis has degree two. Its best choice leaves a stretch, which
        costs an energy that no beam has. Beside the energy of bending:""", xi=XI, u=u_x)
    ends = (-Quotient(LENGTH, node(2)), Quotient(LENGTH, node(2)))
    stretch_form = half * Along(E * WIDTH * HEIGHT * (u_x + half * v_x**2)**2, XI, *ends)
    bend_form = half * Along(E * Quotient(WIDTH * HEIGHT**3, node(12)) * v_xx**2, XI, *ends)
    section = WIDTH.meaning * HEIGHT.meaning
    # xi^4 minus its best quadratic is 8/35 (l/2)^4 P_4 with Legendre's polynomial of degree four; P_4^2 has the mean 1/9.
    left_over = (BETA.meaning**2 / 8 * sympy.Rational(8, 35) * (LENGTH.meaning / 2) ** 4) ** 2 / 9 * LENGTH.meaning
    stretched = Symbol(r"U_\text{stretch}", E.meaning * section * left_over / 2)
    bent = Symbol(r"U_\text{bend}", E.meaning * section * HEIGHT.meaning**2 / 12 * BETA.meaning**2 * LENGTH.meaning**3 / 24)
    page.formulas_of([
        (stretched, stretch_form, Quotient(E * WIDTH * HEIGHT * BETA**4 * LENGTH**9, node(5644800))),
        (bent, bend_form, Quotient(E * WIDTH * HEIGHT**3 * BETA**2 * LENGTH**3, node(288))),
        (Quotient(stretched, bent), Power(Grouped(Quotient(BETA * LENGTH**3, 140 * HEIGHT)), node(2)))],
        how="""The first left side is known from Legendre's polynomial of degree four, which is what no quadratic
        can cancel of a fourth power; the integral has the three coefficients of least energy put in.""")
    page.words("""Half the element's length makes it 64 times smaller: it goes away with the mesh, but for slender
        rods late.""")

    page.section("", "M5 How many Gauss points are exact")
    density = normal(energy_density())
    degrees = dict(zip(("x", "y"), density.degrees()[:2]))
    page.words("""A straight element's strain is of degree four along and two across, its energy of twice that. A
        rule of Gauss integrates polynomials exactly to one degree less than twice the number of its points: five
        points along (degree nine) and three across (five) suffice, and fewer do not, as""")
    page.formulas_of([(Symbol(r"\deg_x", sympy.Integer(degrees["x"])), node(8)),
                      (Symbol(r"\deg_y", sympy.Integer(degrees["y"])), node(4))],
                     how="The left sides are the degrees of the energy's density as a polynomial of the place.")

    page.exercise("Leave out one point, along or across. Which states notice?", "8-another-program")

    page.section("", "M6 No shear correction")
    page.words("""A straight section that leans by the unit angle shears evenly, and the energy is that of an even
        stress:""")
    lean = Symbol(r"\mathbf u_\text{lean}", nodal_rate(field.y, sympy.Integer(0)))
    page.formula(lean.T * tangent * lean, mu * l * h * w,
                 how="""The left side is the second derivative of the energy, at any inclination, along the nodal
        coordinates of such a shear.""")
    page.words("""In a solid the stress is a parabola across the section, zero at both faces, in proportion to {parabola}, and
        carries the same force with more energy. The factor by which an even stress is too stiff is""", parabola=h**2 - 4 * y**2)
    parabola = h**2 - 4 * y**2
    page.formula(Integral("A", parabola)**2, node("5/6") * w * h * Integral("A", parabola**2),
                 how="Both sides are integrated over the section.")
    page.words("""Timoshenko's 5/6. The paper has no such factor, so neither has this project. What it would change: the
        tip of the pendulum without heat by 0.11 mm at most within 2 s, give or take 0.06 (`shear` in
        `fixtures/pendulum.json`), that of the suddenly heated one by a centimetre. The waves of the sudden heat pump
        bending, and the rod without the factor ends up 1.1 cm from the solid, with it half a millimetre (`python -m
        oracle.motion.shear`, some minutes).""")

    page.section("", "M7 One-dimensional heat has a direction")
    page.words("""The model that the paper compares with heats a rod along its axis only. Strains here are in global
        axes, so this heat is a tensor along the rod's initial direction, and the column has three entries:""")
    page.formula(Symbol(r"\boldsymbol\varepsilon_T^\text{1D}", turned(GEN["heat"], Y.ZERO)),
                 heat * Table([cosine()**2, sine()**2, sine() * cosine()]).T,
                 how="""The left side is the tensor with this strain along the rod and none across it, turned into
        global axes.""")
    page.words("""Whoever writes it with a first entry alone heats along the global first axis, whatever the rod's
        direction.""")

    page.section("", "M8 A heated rod between walls")
    page.words("""Its length is held, its section is free to thicken. The axial stress, and the squared stretch
        across with heat in both directions and with heat along the rod only:""")
    (stress, square), (stress_1d, square_1d) = held()
    assert sympy.simplify(stress - stress_1d) == 0
    page.formulas_of([
        (Symbol(r"\sigma_{11}", stress), -Quotient(E * a, 1 - nu**2)),
        (Symbol(r"\mathbf r_y \cdot \mathbf r_y", square), 1 + Quotient(2 * a, 1 - nu)),
        (Symbol(r"(\mathbf r_y \cdot \mathbf r_y)_\text{1D}", square_1d), 1 + Quotient(2 * nu * a, 1 - nu))],
        how="The left sides solve the law for a strain along the rod that is zero and no stress across.")
    page.words("""The stress is the same in both models; beyond the load of Euler the rod buckles. A clamp that also
        held the thickness would disturb all this near the wall: the clamps here hold the section's direction only.""")


def energy_density():
    """Density of the strain energy in the rod's own axes."""
    strain = Y.own_strain()
    stress = Y.hooke(strain)
    return sum((strain[i, j] * stress[i, j] * Y.HALF for i in Y.PLANE for j in Y.PLANE), Y.ZERO)
