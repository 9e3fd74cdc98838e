"""The tangent, and the element at rest: the stiffness matrix of small displacements, written out."""

from . import symbols as Y
from .algebra import GEN, NODAL, Matrix, column, entries, hessian, normal, over, replace
from .calculus import Integral
from .force import K, Q_e, U, quarter
from .notation import PRODUCT, Quotient, Symbol, Table, node
from .symbols import (S_a1, S_b1, S_c1, e, e_0, eps_1, eps_2, eps_3, h, heat, l, lam, mu, row, w, xi)

# Coordinates that stretch a horizontal element, and those that bend it, as numbers in (4): of positions and of the slope along,
# then of the slopes across.
STRETCH, BEND = (0, 4, 6, 10, 3, 9, 13), (1, 5, 7, 11, 2, 8, 12)


# Nodal vectors to be named in words.
NODES = {f"r_{name}": Symbol(rf"\mathbf r{text}", 0) for name, text in (("i", "^i"), ("j", "^j"), ("xj", "_x^j"), ("k", "^k"))}
SLOPES = {f"y_{name}": Symbol(rf"\mathbf r_y^{name}", 0) for name in "ijk"}


def at_rest(meaning):
    """Polynomials at the straight element, at any inclination."""
    rest = dict(zip(NODAL, entries(e_0.meaning)))
    return meaning.each(lambda value: normal(replace(value, **rest)))


def horizontal(meaning):
    """Polynomials at the inclination zero."""
    return meaning.each(lambda value: normal(replace(value, c=Y.ONE, s=Y.ZERO)))


def tangent_at_rest():
    """Second derivatives of U at the cold, straight element, at any inclination."""
    return at_rest(hessian(replace(U.meaning, heat=Y.ZERO), NODAL))


TANGENT = tangent_at_rest()
LEVEL = horizontal(TANGENT)
K_0 = Symbol(r"\mathbf K_0", LEVEL)


def part(rows, columns):
    """Some rows and columns of the tangent of the horizontal element at rest."""
    return Matrix([[LEVEL[i, j] for j in columns] for i in rows])


STRETCHING, BENDING = (Symbol(rf"\mathbf K_\text{{{name}}}", part(group, group)) for name, group in (("stretch", STRETCH), ("bend", BEND)))


def integrals(first, second, factor):
    """l times the integrals of products of derivatives of shape functions over the axis."""
    return Matrix([[normal(over(f * g, True, False) * factor) for g in second] for f in first])


def number_matrices():
    """The four matrices of integrals of shape functions along the axis, with their symbols."""
    along = [Y.SHAPES[k].derivative("x") for k in (0, 2, 3, 5)]
    across = [Y.SHAPES[k].derivative("y") for k in (1, 4, 6)]
    curved = [f.derivative("x") for f in across]
    l_, per_l = GEN["l"], GEN["per_l"]
    return (Symbol(r"\mathbf P", integrals(along, along, l_)), Symbol(r"\mathbf G", integrals(along, across, Y.ONE)),
            Symbol(r"\mathbf N", integrals(across, across, per_l)), Symbol(r"\mathbf H", integrals(curved, curved, l_ * Y.fmpq(1, 12))))


P, G, N, H = number_matrices()


def write(page):
    """The end of the chapter on forces."""
    page.section("", "The tangent", ["equations.force::tangent"])
    page.words("""Newton's iteration needs to know how the forces change with {e}; the paper leaves it out. By the
        product rule: {K} once, and once the derivative of what is in the brackets of (21). These are twice the
        strains, with the derivatives""", e=e, K=K)
    a, b, c = (Symbol(rf"\mathbf z_{name}", column([form.derivative(n) * 2 for n in NODAL]))
               for name, form in zip("abc", (eps_1.meaning, eps_2.meaning, eps_3.meaning)))
    page.formulas_of([(a, S_a1 * e), (b, S_b1 * e), (c, S_c1 * e)],
                     how="""The left sides are the derivatives of twice the strains that are found from the lengths
        of fibres.""")
    page.words("So the tangent is")

    def outer(p, q):
        return p * q.T

    change = Matrix([[component.derivative(name) for name in NODAL] for (component,) in Q_e.meaning.rows])
    page.formula(Symbol(r"\frac{\partial \mathbf Q_e}{\partial \mathbf e}", change),
                 K + quarter * Integral("V", (lam + 2 * mu) * (outer(a, a) + outer(b, b)) + lam * (outer(a, b) + outer(b, a))
                                        + 4 * mu * outer(c, c)),
                 how="The left side holds the derivatives of the force of virtual work.")
    page.words("""{K} holds the stresses and is called the geometric part, the integral holds the elasticity, the
        material part. Both are symmetric, as second derivatives are.""", K=K)

    page.section("", "At rest", ["equations.force::tangent"])
    page.words("""The cold element that nobody has touched has no strain, so its {K} is zero: the matrix that the paper calls
        stiffness holds stresses only. Heated and held as it was, it has""", K=K)
    page.formula(Symbol(r"\mathbf K(\mathbf e_0)", at_rest(K.meaning)), -((lam + mu) * heat * Integral("V", S_a1 + S_b1)),
                 how="The left side is the matrix above at the nodal coordinates of a straight element at any inclination.")
    page.words("""What small displacements meet is the tangent at rest. Take a horizontal element, {zero}, where {rx} and
        {ry}, so that {J}. Then (11) is {S_a}, {S_b}, and {S_c}. Their products with {e_0} contain {one}, the first
        component of {r_x}, which is one, and {two}, its second, which is zero; likewise for {r_y}. So the columns of
        the tangent become rows of derivatives of {S}:""", zero=Symbol(r"\theta = 0", 0),
               rx=Symbol(r"\mathbf r_x = \begin{bmatrix}1 & 0\end{bmatrix}^{\mathsf T}", 0),
               ry=Symbol(r"\mathbf r_y = \begin{bmatrix}0 & 1\end{bmatrix}^{\mathsf T}", 0), J=Symbol(r"\mathbf J = \mathbf I", 0),
               S_a=Symbol(r"\mathbf S_a = \mathbf S_{1x}^{\mathsf T} \mathbf S_{1x} + \mathbf S_{2x}^{\mathsf T} \mathbf S_{2x}", 0), S=Y.S,
               S_b=Symbol(r"\mathbf S_b = \mathbf S_{1y}^{\mathsf T} \mathbf S_{1y} + \mathbf S_{2y}^{\mathsf T} \mathbf S_{2y}", 0),
               S_c=Symbol(r"\mathbf S_c = \mathbf S_{1x}^{\mathsf T} \mathbf S_{1y} + \mathbf S_{2x}^{\mathsf T} \mathbf S_{2y}", 0), 
               e_0=e_0, one=row(1, "x") * e_0, two=row(2, "x") * e_0,
               r_x=Y.r_x, r_y=Y.r_y)
    level = [Symbol(rf"{symbol.text}(\mathbf e_0)", horizontal(at_rest(symbol.meaning))) for symbol in (a, b, c)]
    page.formulas_of([(level[0], 2 * row(1, "x").T), (level[1], 2 * row(2, "y").T), (level[2], row(1, "y").T + row(2, "x").T)],
                     how="The left sides are those above at the nodal coordinates of the horizontal element.")
    page.words("""So the tangent at rest, called {K_0}, is""", K_0=K_0)
    one_x, two_y, shear = row(1, "x"), row(2, "y"), row(1, "y") + row(2, "x")
    page.formula(K_0, Integral("V", (lam + 2 * mu) * (one_x.T * one_x + two_y.T * two_y)
                               + lam * (one_x.T * two_y + two_y.T * one_x) + mu * shear.T * shear),
                 how="The left side holds the second derivatives of the energy.")
    page.words("""One entry by hand, that of the first coordinate, which moves the beginning along the rod. It is a first
        component, so by (2) it is in {S_1x}, in which it has the factor {slope}, and in {S_1y}, where its factor is
        zero, as {S_1} does not contain {y}. The volume is the section times the length, and the mean of a power of
        {xi} one over its exponent plus one. By (3)""", S_1x=one_x, S_1y=row(1, "y"), S_1=Symbol("S_1", 0), y=Y.y, xi=xi,
               slope=Symbol(r"\frac{\partial S_1}{\partial x}", 0))
    slope = Symbol(r"\frac{\partial S_1}{\partial x}", Y.SHAPES[0].derivative("x"), PRODUCT)
    page.formulas_of([
        (slope, Quotient(node(-5) + 16 * xi - 12 * xi**2, l)),
        (l**2 * slope**2, 25 - 160 * xi + 376 * xi**2 - 384 * xi**3 + 144 * xi**4),
        (Symbol("K_{0,11}", LEVEL[0, 0]), (lam + 2 * mu) * Integral("V", slope**2),
         Quotient((lam + 2 * mu) * h * w, l) * (node(25) - node(80) + node("376/3") - node(96) + node("144/5")),
         node("47/15") * Quotient((lam + 2 * mu) * h * w, l))],
        how="The left side is the second derivative of the energy by the first coordinate, twice.")
    page.words("""All entries are of four kinds. Let {P} hold {l} times the integrals of products of derivatives along,
        for {r_i}, {r_j}, {r_xj}, {r_k}; {N} those of derivatives across, for the slopes {y_i}, {y_j}, {y_k}, over
        {l}; {G} the mixed ones; {H} those of second derivatives of the slopes' functions, times {twelfth}:""",
               P=P, G=G, N=N, H=H, l=l, twelfth=Quotient(l, node(12)), **NODES, **SLOPES)
    f, o = node, node(0)
    fifth = node("4/5")
    page.formulas_of([
        (P, Table([f("47/15"), -f("8/3"), fifth * l, -f("7/15")], [-f("8/3"), f("16/3"), o, -f("8/3")],
                  [fifth * l, o, fifth * l**2, -(fifth * l)], [-f("7/15"), -f("8/3"), -(fifth * l), f("47/15")])),
        (G, Table([-f("19/30"), -f("2/5"), f("1/30")], [f("2/3"), o, -f("2/3")],
                  [-Quotient(2 * l, f(15)), Quotient(4 * l, f(15)), -Quotient(2 * l, f(15))], [-f("1/30"), f("2/5"), f("19/30")])),
        (N, Table([f("2/15"), f("1/15"), -f("1/30")], [f("1/15"), f("8/15"), f("1/15")], [-f("1/30"), f("1/15"), f("2/15")])),
        (H, Table([f("7/36"), -f("2/9"), f("1/36")], [-f("2/9"), f("4/9"), -f("2/9")], [f("1/36"), -f("2/9"), f("7/36")]))],
        how="The left sides are integrals of the shape functions derived in (3).")
    page.words("""Horizontal, the 14 coordinates fall apart into seven that stretch the element, the first components of
        {r_i}, {r_j}, {r_xj}, {r_k} and the second of the slopes across, and seven that bend it, the others. In this
        order the whole of {K_0} is""", K_0=K_0,
               **NODES)
    normal_, volume = lam + 2 * mu, h * w

    def half_of(strong, mixed, weak):
        """Seven rows: modulus of slopes along the coordinate, of products with the slopes across, of their derivatives."""
        return volume * Table([Quotient(strong, l) * P, mixed * G], [mixed * G.T, strong * l * N + weak * Quotient(h**2, l) * H])

    page.formulas_of([(STRETCHING, half_of(normal_, lam, mu)), (BENDING, half_of(mu, mu, normal_))],
                     how="The left sides are rows and columns of the second derivatives of the energy; all other entries are zero.")
    assert all(entry == 0 for entry in entries(part(STRETCH, BEND)))
    page.words("""The second is the first with {mu} and {strong} exchanged, and {mu} for {lam}: what is stretching along
        is shear across. An inclined element has the same matrix, turned.""", mu=mu, lam=lam, strong=normal_)
    page.exercise("""Find the entry of {K_0} that belongs to the middle's position along the rod, twice. Then: which
        force does E2 put on the element at rest?""",
                  "3-rest", K_0=K_0)
