"""(8)-(14): strain, thermal strain and their difference."""

from . import symbols as Y
from .algebra import GEN, Matrix, column, normal
from .calculus import Total
from .notation import Inverse, Symbol, Table, node
from .symbols import (I, J, J_0, PLANE, S_a, S_b, S_c, S_x, S_y, cosine, e, e_0, eps, eps_1, eps_2, eps_3, eps_f, eps_m,
                      eps_T, heat, r_x, r_y, row, sine, theta)


def turned(along, across):
    """R diag(along, across) R^T as (11, 22, 12), the strain with these principal values along and across the rod."""
    R, c = J_0.meaning, (along, across)
    tensor = [[normal(sum((R[i, k] * c[k] * R[j, k] for k in PLANE), Y.ZERO)) for j in PLANE] for i in PLANE]
    return Y.vector(Matrix(tensor))


def write(page):
    """The chapter."""
    page.heading("3 Strain: what deformation is")
    page.words("""A strain has to vanish when the element is moved and turned as a whole. So it cannot be read off
        the slopes alone; they have to be compared with those at the start.""")

    page.section("8", "Thermal strain", ["equations.strain::eps_T", "equations.strain::eps_T_1d"])
    page.words("""A free body heated by {dT} grows by the same fraction in every direction, at first order {heat};
        its angles stay. Strains are symmetric tensors with the components 11, 22 and 12, written as a column.""", dT=Symbol(r"\Delta T", 0), heat=heat)
    symbol = Symbol(eps_T.text, turned(GEN["heat"], GEN["heat"]))
    page.formula(symbol, Table([heat, heat, 0]).T, number="8",
                 how="""The left side is the tensor with this strain along the rod and across it, turned into global
        axes from any inclination.""")
    page.words("""It is the same in every frame; that is why it can be written down without saying which. (The paper
        prints a row where a column is meant, E5. The competitor that heats the axis only is
        [M7](#m7-one-dimensional-heat-has-a-direction).)""")

    page.section("", "The initial direction", ["equations.strain::J_0", "equations.strain::J_0_theta"])
    page.words("""The paper uses an angle {theta} without saying what it is (E5): the inclination of the straight,
        unstretched element at the start, from the global first axis to its own. Let {e_0} be the nodal coordinates
        there. The gradient of the initial position by {x} and {y} is then a rotation:""", theta=theta, e_0=e_0, x=Y.x, y=Y.y)
    page.formula(J_0, Table([S_x * e_0, S_y * e_0]), Table([cosine(), -sine()], [sine(), cosine()]),
                 how="""The middle uses the shape functions and what (A.2) reads off a straight element that begins
        anywhere.""")

    page.section("9", "Deformation gradient", ["equations.strain::J"])
    page.figure("deformation", """A short fibre before and now: the deformation gradient takes one to the other""")
    page.words("""How do neighbouring points move apart? A short fibre between two of them was {dr_0} and is now
        {dr}; the matrix that takes one to the other is the deformation gradient. The position is known as a
        function of {x} and {y}, not of the initial position, so the chain rule is needed, and that is all that (9)
        says. {S_1x} is the first row of {S}, differentiated by {x}. (The paper's symbol with one index is a
        function in (2) and a row here, E5.)""",
               dr_0=Symbol(r"\mathrm d\mathbf r_0", 0), dr=Symbol(r"\mathrm d\mathbf r", 0), x=Y.x, y=Y.y, S=Y.S, S_1x=row(1, "x"))
    page.formula(J, Table([row(1, "x") * e, row(1, "y") * e], [row(2, "x") * e, row(2, "y") * e]) * Inverse(J_0), number="9",
                 how="""The left side is differentiated by the initial position itself, of which the field is
        written as a function.""")

    page.words("""The columns of the first matrix are {r_x} and {r_y}, by (1). The inverse of a rotation is its transpose;
        with it the columns of {J} are""", r_x=r_x, r_y=r_y, J=J)
    cos, sin = cosine, sine
    page.formulas_of([
        (Inverse(J_0), Table([cos(), sin()], [-sin(), cos()])),
        (J, Table([r_x, r_y]) * Inverse(J_0), Table([r_x * cos() - r_y * sin(), r_x * sin() + r_y * cos()]))],
        how="The slopes are the derivatives of the position; the left sides as above.")

    page.section("10", "The strain tensor", ["equations.strain::eps_m", "equations.strain::S_abc"])
    page.words("""Green and Lagrange measure by squares of lengths, because these are polynomials in the
        coordinates. Half the change of a fibre's squared length is a quadratic form of the fibre, and the form's
        matrix is the strain: with {moved}, the squared length now is {square}.""", moved=Symbol(r"\mathrm d\mathbf r = \mathbf J \mathrm d\mathbf r_0", 0),
               square=Symbol(r"\mathrm d\mathbf r_0^{\mathsf T} \mathbf J^{\mathsf T} \mathbf J \mathrm d\mathbf r_0", 0))
    fibre_0 = Symbol(r"\mathrm d\mathbf r_0", column([GEN["g1"], GEN["g2"]]))
    moved = Symbol(r"\mathrm d\mathbf r", J.meaning @ fibre_0.meaning)
    page.formula(moved.T * moved - fibre_0.T * fibre_0, 2 * fibre_0.T * eps_m * fibre_0,
                 how="""The left side is computed from the gradient for any fibre; the strain from the lengths of
        four special ones.""")
    half = node("1/2")
    page.formula(eps_m, half * (J.T * J - I),
                 half * Table([e.T * S_a * e - 1, e.T * S_c * e], [e.T * S_c * e, e.T * S_b * e - 1]), number="10",
                 how="""The left side is found from the lengths of fibres along both axes and both diagonals; the
        matrices with indices from the products of gradients, each for one nodal coordinate alone.""")

    page.words("""It is zero for a rotation, since then {JJ} is {I}.""", JJ=J.T * J, I=I)

    page.section("11", "The metric's matrices", ["equations.strain::S_abc_theta"])
    page.words("""Each entry of {JJ} is the product of two columns of {J}. Multiplying out, with the columns found at (9):""", JJ=J.T * J, J=J)
    page.formulas_of([
        (e.T * S_a * e, r_x.T * r_x * cos()**2 - 2 * r_x.T * r_y * sin() * cos() + r_y.T * r_y * sin()**2),
        (e.T * S_b * e, r_x.T * r_x * sin()**2 + 2 * r_x.T * r_y * sin() * cos() + r_y.T * r_y * cos()**2),
        (e.T * S_c * e, r_x.T * r_x * sin() * cos() + r_x.T * r_y * (cos()**2 - sin()**2) - r_y.T * r_y * sin() * cos())],
        how="The matrices are those of products of gradients, each for one nodal coordinate alone.")
    page.words("""Along the global first axis, at {zero}, these are the slopes' products alone. Now put {r_x} and {r_y},
        row by row: the product of two slopes is a sum over the two rows {p} of {S}, such as {product}. What stands
        between {eT} and {e} depends on the place and on {theta} alone:""", zero=Symbol(r"\theta = 0", 0), r_x=Symbol(r"\mathbf r_x = \mathbf S_x \mathbf e", 0),
               r_y=Symbol(r"\mathbf r_y = \mathbf S_y \mathbf e", 0), S=Y.S, p=Symbol("p", 0), eT=e.T, e=e, theta=theta,
               product=Symbol(r"\mathbf e^{\mathsf T} \mathbf S_{px}^{\mathsf T} \mathbf S_{py} \mathbf e", 0))

    def product(a, b):
        return lambda i: row(i, a).T * row(i, b)

    def form(xx, xy, yx, yy):
        """The four products with their factors under one sum."""
        return Total(lambda i: xx(product("x", "x")(i)) + xy(product("x", "y")(i)) + yx(product("y", "x")(i))
                     + yy(product("y", "y")(i)), index="p")

    cc, ss = (lambda f: f * cos()**2), (lambda f: f * sin()**2)
    sc, minus_sc = (lambda f: f * sin() * cos()), (lambda f: -(f * sin() * cos()))
    minus_ss = (lambda f: -(f * sin()**2))
    page.formulas_of([
        (S_a, form(cc, minus_sc, minus_sc, ss)),
        (S_b, form(ss, sc, sc, cc)),
        (S_c, form(sc, cc, minus_ss, minus_sc))],
        number="11", how="The left sides come from products of gradients, each for one nodal coordinate alone.")
    page.words("""{S_c} is not symmetric; where only its quadratic form counts, that makes no difference, but
        whoever differentiates it must take both halves.""", S_c=S_c)

    page.section("12", "Strain as a column", ["equations.strain::eps_f"])
    page.formula(eps_f, Table([eps_1, eps_2, eps_3]).T, number="12",
                 how="The left side is the tensor's components 11, 22 and 12.")

    page.section("13", "The three strains",
                 ["equations.strain::eps_1", "equations.strain::eps_2", "equations.strain::eps_3"])
    page.words("""The third is the tensor's component 12, half of what engineers call the shear strain. Everything
        that goes wrong with shear further down begins here.""")
    page.formulas_of([
        (eps_1, half * (e.T * S_a * e - 1)), (eps_2, half * (e.T * S_b * e - 1)), (eps_3, half * e.T * S_c * e)],
        number="13", how="The left sides are found from the lengths of fibres.")

    page.section("14", "The strain that makes stress", ["equations.strain::eps"])
    page.words("""A body that has expanded freely is as long as it wants to be. What it resists is the deformation
        beyond that:""")
    page.formula(eps, eps_f - eps_T, number="14",
                 how="The left side is half the difference of the metric and that of the freely expanded body.")
    page.words("""The freely expanded body is the one whose squared lengths have grown by the factor {free}: more of
        it in [M2](#m2-the-stress-free-stretch-is-a-root).""", free=1 + 2 * heat)
