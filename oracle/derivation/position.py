"""(A.1)-(A.5) and (1)-(5): from a polynomial to shape functions."""

import sympy

from ..element import field
from .algebra import Matrix, column
from .calculus import Determinant, Where
from .notation import PRODUCT, Named, Quotient, Symbol, Table, node
from .symbols import I, PLANE

TEXTS = (r"\mathbf r^i", r"\mathbf r_y^i", r"\mathbf r^j", r"\mathbf r_x^j", r"\mathbf r_y^j", r"\mathbf r^k",
         r"\mathbf r_y^k")
x, y, l = (Symbol(str(s), s) for s in (field.x, field.y, field.l))
a, b = Symbol("a", field.x / field.l), Symbol("b", field.y / field.l)

# The two components of each nodal vector, and of an expression in one component's nodal values.
PAIRS = [[sympy.Symbol(f"{value}_{i + 1}") for i in PLANE] for value in field.NODAL]
NODAL = [Symbol(text, column(pair)) for text, pair in zip(TEXTS, PAIRS)]
r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k = NODAL


def both(expression):
    """Both components of an expression in nodal values."""
    return column([sympy.expand(expression.subs({v: pair[i] for v, pair in zip(field.NODAL, PAIRS)})) for i in PLANE])


SOLVED = both(field.polynomial(field.coefficients()))
r = Symbol(r"\mathbf r", SOLVED)
e = Symbol(r"\mathbf e", column([entry for pair in PAIRS for entry in pair]))
SHAPES = [Symbol(f"S_{k + 1}", shape) for k, shape in enumerate(field.shape_functions())]
S_1, S_2, S_3, S_4, S_5, S_6, S_7 = SHAPES
S = Symbol(r"\mathbf S", Matrix([[sympy.diff(component, entry) for (entry,) in e.meaning.rows]
                                 for (component,) in SOLVED.rows]))


def derivative(name, function=r):
    """The slope r_x or r_y of a field."""
    return Symbol(rf"{function.text}_{name}", function.meaning.each(lambda entry: sympy.diff(entry, sympy.Symbol(name))))


def coefficient(k):
    """The column of a_k and b_k, as symbols."""
    return Table([Symbol(f"a_{k}", sympy.Symbol(f"a_{k}"))], [Symbol(f"b_{k}", sympy.Symbol(f"b_{k}"))])


def write(page):
    """The chapter."""
    page.heading("1 Position: from a polynomial to shape functions")
    page.words("""A beam element has to say where each of its material points is. It does so with few numbers:
        vectors at three nodes, {i} at one end, {j} in the middle, {k} at the other end, between which the position
        is interpolated.""",
               i=Symbol("i", 0), j=Symbol("j", 0), k=Symbol("k", 0))
    page.drawing("""
       y
       ^ r_y^i               ^ r_y^j               ^ r_y^k
 h/2 - +---------------------|---------------------+
       |                     |                     |
   0 - o i                 j o------> r_x^j        o k - - > x
       |                                           |
-h/2 - +-------------------------------------------+
       0                    l/2                    l
""")
    page.words("""The coordinates {x} along the element and {y} across it name a material point and never change;
        {r} is where that point is now, in global axes. A subscript {x} or {y} is a derivative: {r_x} and {r_y}, the
        *slopes*, tell how the fibres along and across the element are turned and stretched. Unstretched, both have
        the length one.""",
               x=x, y=y, r=r, r_x=derivative("x"), r_y=derivative("y"))

    page.section("A.1", "The polynomial", ["equations.shape::r_polynomial"])
    A = [sympy.symbols(f"{letter}_0:7") for letter in "ab"]
    field_xy = Symbol(r"\mathbf r(x, y)", column([field.polynomial(letters) for letters in A]))

    def component(letter):
        k = [Symbol(f"{letter}_{n}", sympy.Symbol(f"{letter}_{n}")) for n in range(7)]
        return k[0] + k[1] * x + k[2] * y + k[3] * x * y + k[4] * x**2 + k[5] * x**3 + k[6] * x**2 * y

    page.words("""The premise of everything. Each component of the position is a polynomial, cubic along the axis
        and linear across it: a section stays straight (but may turn against the axis, which is shear, and may
        stretch, which is where heat across the rod shows), and its slope {r_y} is quadratic along the axis.""", r_y=derivative("y"))
    page.formula(field_xy, Table([component("a")], [component("b")]), number="A.1",
                 how="A premise: compared with the field from which the [oracle](element/field.py) derives its numbers.")
    page.words("""The paper lets the coefficients run from 1 to 7 (a slip, E5). They run from 0 to 6: without the
        first, the point {place} could not move.""", place=Symbol("x = y = 0", 0))
    page.formula(Where(Symbol(r"\mathbf r", field_xy.meaning), 0, 0), coefficient(0),
                 how="The left side is (A.1) at a place.")

    page.section("A.2", "What the nodal vectors are", ["equations.shape::nodal_conditions"])
    page.words("""Seven vectors are to take the place of the seven pairs of coefficients, because a neighbouring
        element can share vectors but not coefficients. So we ask of the polynomial that it has the position and the
        slope across at all three nodes, and the slope along in the middle:""")
    r_x, r_y = derivative("x"), derivative("y")
    half = Quotient(l, node(2))
    page.formulas_of([
        (Where(r, 0, 0), r_i), (Where(r_y, 0, 0), r_y_i),
        (Where(r, l, 0), r_k), (Where(r_y, l, 0), r_y_k),
        (Where(r, half, 0), r_j), (Where(r_x, half, 0), r_x_j), (Where(r_y, half, 0), r_y_j)],
        number="A.2", blind=("0 + 1",),
        how="The left sides are the field with the coefficients (A.3) below, and its derivatives, at the nodes.")
    free = sympy.symbols("a_0:7")
    system = sympy.Matrix([[sympy.diff(value, k) for k in free] for value in field.nodal_values(field.polynomial(free))])
    page.words("""These are seven linear equations for the seven coefficients of each component. They have exactly
        one solution, because their determinant is not zero for any length:""")
    page.formula(Determinant(Symbol(r"\frac{\partial (\mathbf r^i, \mathbf r_y^i, \dots, \mathbf r_y^k)}{\partial (a_0, \dots, a_6)}",
                                    Matrix(system.tolist()), PRODUCT)), Quotient(l**8, node(64)),
                 how="""The left side is the determinant of the derivatives of (A.2), taken of (A.1) with free
        coefficients.""")

    page.section("A.3", "The coefficients", ["equations.shape::coefficients", "equations.shape::coefficients_printed"])
    solution = [both(expression) for expression in field.coefficients()]

    def solved(k):
        return Symbol(rf"\begin{{bmatrix}} a_{k} \\ b_{k} \end{{bmatrix}}", solution[k])

    page.formulas_of([
        (solved(0), r_i),
        (solved(1), -Quotient(5 * r_i - 4 * r_j - r_k + 2 * l * r_x_j, l)),
        (solved(2), r_y_i),
        (solved(3), -Quotient(3 * r_y_i - 4 * r_y_j + r_y_k, l)),
        (solved(4), Quotient(8 * r_i - 4 * r_j - 4 * r_k + 6 * l * r_x_j, l**2)),
        (solved(5), -Quotient(4 * r_i - 4 * r_k + 4 * l * r_x_j, l**3)),
        (solved(6), Quotient(2 * r_y_i - 4 * r_y_j + 2 * r_y_k, l**2))],
        number="A.3", how="The left sides are the solution of (A.2), which a computer algebra system finds.")
    page.words("""**E1, an error in the paper.** It prints the last but one sign in the second line as a plus:""")
    printed = -Quotient(5 * r_i - 4 * r_j + r_k + 2 * l * r_x_j, l)
    page.formula(Named("printed", printed), solved(1) - Quotient(2 * r_k, l),
                 how="Both sides are computed; the first term on the right is the solution of (A.2).")
    page.words("""With that coefficient the end of the element is not where its own node is, but at its mirror
        image:""")
    wrong = Symbol(r"\mathbf r_\text{printed}", both(field.polynomial(field.coefficients_printed())))
    page.formula(Where(wrong, l, 0), -r_k, how="The left side is (A.1) with the printed (A.3), at a place.")

    page.section("A.4", "Position by the nodal vectors", ["equations.shape::r_nodal"])
    page.words("""Put (A.3) into (A.1) and sort by nodal vectors. With {a} and {b} as short names of""", a=a, b=b)
    page.formulas_of([(a, Quotient(x, l)), (b, Quotient(y, l))],
                     how="Definitions; everything below is computed with them.")
    page.words("this is")
    page.formula(
        Symbol(r"\mathbf r(x, y)", SOLVED),
        (1 - 5 * a + 8 * a**2 - 4 * a**3) * r_i + l * b * (1 - 3 * a + 2 * a**2) * r_y_i + (4 * a - 4 * a**2) * r_j
        + l * a * (-node(2) + 6 * a - 4 * a**2) * r_x_j + l * b * (4 * a - 4 * a**2) * r_y_j
        + (a - 4 * a**2 + 4 * a**3) * r_k + l * b * (-a + 2 * a**2) * r_y_k,
        number="A.4", how="The left side is (A.1) with the solution of (A.2).")

    page.section("1", "Position is a matrix times the nodal coordinates", ["equations.shape::r"])
    page.words("""(A.4) is linear in the nodal vectors. Write their components as one column {e} of 14 numbers, and
        what multiplies them as a matrix {S} of two rows and 14 columns:""", e=e, S=S)
    page.formula(r, S * e, number="1", how="The left side is (A.1) with the solution of (A.2).")
    page.words("""Why this matters: {S} depends on {x} and {y} but not on time, {e} on time but not on place. All
        integrals over the element can be done with {S} alone, once. And as {e} holds global positions and slopes,
        no rotation is ever split off: that is what *absolute* nodal coordinates means.""", S=S, e=e, x=x, y=y)

    page.section("2", "The shape matrix", ["equations.shape::S"])
    page.formula(S, Table([S_1 * I, S_2 * I, S_3 * I, S_4 * I, S_5 * I, S_6 * I, S_7 * I]), number="2",
                 how="The left side is the derivative of the position by the nodal coordinates.")
    page.words("""{I} is the unit matrix of two rows: both components are interpolated in the same way.""", I=I)

    page.section("3", "The shape functions", ["equations.shape::S_i"])
    page.formulas_of([
        (S_1, 1 - 5 * a + 8 * a**2 - 4 * a**3), (S_2, l * b * (1 - 3 * a + 2 * a**2)), (S_3, 4 * a - 4 * a**2),
        (S_4, l * a * (-node(2) + 6 * a - 4 * a**2)), (S_5, l * b * (4 * a - 4 * a**2)),
        (S_6, a - 4 * a**2 + 4 * a**3), (S_7, l * b * (-a + 2 * a**2))],
        number="3", how="""The left sides are the derivatives of (A.1), with the solution of (A.2), by the nodal
        vectors.""")
    page.words("""Those of positions ({S_1}, {S_3}, {S_6}) are numbers, those of slopes lengths in m.""", S_1=S_1, S_3=S_3, S_6=S_6)

    page.section("4", "The nodal coordinates", ["equations.shape::e", "equations.shape::nodes"])
    read = zip(*[field.nodal_values(component) for (component,) in SOLVED.rows])
    page.formula(Symbol(r"\mathbf e", column([sympy.expand(value) for pair in read for value in pair])),
                 Table([vector.T for vector in NODAL]).T, number="4",
                 how="The left side is what (A.2) reads off the field, node by node.")

    page.section("A.5", "What interpolation keeps", ["equations.shape::S", "equations.shape::e"])
    page.words("""(A.5) collects (2), (3) and (4). Three sums tell whether the collection is right: an element that
        is moved as a whole must move as a whole, and one at rest must lie where its points are, along the axis and
        across it.""")
    page.formulas_of([(S_1 + S_3 + S_6, node(1)), (S_4 + Quotient(l, node(2)) * S_3 + l * S_6, x), (S_2 + S_5 + S_7, y)],
                     number="A.5", how="The functions are those derived in (3).")
    page.words("""So any motion without strain, and any uniform strain, is represented exactly: the element is
        complete, without which refining a mesh need not approach anything. That is less than what engineers call the patch
        test. It asks whether elements under the loads of a uniform stress also *take* that state, and so of the forces as
        well.""")

    page.section("5", "Velocity", ["equations.shape::r_dot"])
    t = sympy.Symbol("t")
    moving = {entry: sympy.Function(str(entry))(t) for pair in PAIRS for entry in pair}
    rates = {f.diff(t): sympy.Symbol(f"{entry}_dot") for entry, f in moving.items()}
    still = {f: entry for entry, f in moving.items()}

    def rate(value):
        return value.each(lambda entry: sympy.expand(entry.subs(moving).diff(t).subs(rates).subs(still)))

    page.words("""The shape functions do not depend on time, so only the nodal coordinates are differentiated. (A
        dot is a derivative by time.)""")
    page.formula(Symbol(r"\dot{\mathbf r}", rate(SOLVED)), S * Symbol(r"\dot{\mathbf e}", rate(e.meaning)), number="5",
                 how="The left side is the time derivative of (A.1) with nodal vectors that are functions of time.")

