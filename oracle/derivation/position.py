"""(A.1)-(A.4) and (3): from a polynomial to shape functions, solved by hand."""

import sympy

from ..element import field
from .algebra import Matrix, column
from .calculus import Where
from .notation import Quotient, Symbol, Table, node
from .symbols import PLANE

TEXTS = (r"\mathbf r^i", r"\mathbf r_y^i", r"\mathbf r^j", r"\mathbf r_x^j", r"\mathbf r_y^j", r"\mathbf r^k",
         r"\mathbf r_y^k")
x, y, l = (Symbol(str(s), s) for s in (field.x, field.y, field.l))
a, b = Symbol(r"\xi", field.x / field.l), Symbol(r"\eta", field.y / field.l)

# The two components of each nodal vector, and of an expression in one component's nodal values.
PAIRS = [[sympy.Symbol(f"{value}_{i + 1}") for i in PLANE] for value in field.NODAL]
NODAL = [Symbol(text, column(pair)) for text, pair in zip(TEXTS, PAIRS)]
r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k = NODAL


def both(expression):
    """Both components of an expression in nodal values."""
    return column([sympy.expand(expression.subs({v: pair[i] for v, pair in zip(field.NODAL, PAIRS)})) for i in PLANE])


# The columns of the coefficients a_n and b_n, as the oracle solves (A.2).
SOLUTION = [both(expression) for expression in field.coefficients()]
COEFFICIENTS = [Symbol(rf"\mathbf a_{n}", value) for n, value in enumerate(SOLUTION)]
a_0, a_1, a_2, a_3, a_4, a_5, a_6 = COEFFICIENTS
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


def component(letter, i):
    """One line of (A.1)."""
    k = [Symbol(f"{letter}_{n}", value[i, 0]) for n, value in enumerate(SOLUTION)]
    return k[0] + k[1] * x + k[2] * y + k[3] * x * y + k[4] * x**2 + k[5] * x**3 + k[6] * x**2 * y


def write(page):
    """The chapter as far as the first exercise."""
    r_x, r_y = derivative("x"), derivative("y")
    half = Quotient(l, node(2))
    page.heading("1 Position: from a polynomial to shape functions")
    page.words("""A beam element says where each of its points is by few numbers: vectors at three nodes, {i} at one
        end, {j} in the middle, {k} at the other end.""", i=Symbol("i", 0), j=Symbol("j", 0), k=Symbol("k", 0))
    page.figure("element", """The element in its own coordinates, and deformed: nodes, and the seven vectors that move it""")
    page.words("""{x} along the element and {y} across it name a material point and never change; {r} is where that
        point is now. The *slopes* {r_x} and {r_y} are its derivatives: they tell how fibres along and across are
        turned and stretched. Unstretched, they have the length one.""", x=x, y=y, r=r, r_x=r_x, r_y=r_y)

    page.figure("slopes", "Fibres of the deformed element, and the slopes at one point")

    page.section("A.1", "The polynomial", ["equations.shape::r_polynomial"])
    page.words("""The premise: each component is a polynomial, cubic along the axis and linear across. A section stays
        straight, but may lean (shear) and stretch (heat).""")
    page.formula(r, Table([component("a", 0)], [component("b", 1)]), number="A.1",
                 how="A premise: compared with the field from which the [oracle](element/field.py) derives its numbers.")
    page.words("""(The paper counts the coefficients from 1 to 7, a slip, E5.) Write {a_n} for the column of {one} and
        {two}.""", a_n=Symbol(r"\mathbf a_n", 0), one=Symbol("a_n", 0), two=Symbol("b_n", 0))

    page.section("A.2", "What the nodal vectors are", ["equations.shape::nodal_conditions"])
    page.words("""A neighbouring element can share vectors, not coefficients. So we ask of the polynomial that it has
        the position and the slope across at all three nodes, and the slope along in the middle:""")
    page.formulas_of([
        (Where(r, 0, 0), r_i), (Where(r_y, 0, 0), r_y_i),
        (Where(r, l, 0), r_k), (Where(r_y, l, 0), r_y_k),
        (Where(r, half, 0), r_j), (Where(r_x, half, 0), r_x_j), (Where(r_y, half, 0), r_y_j)],
        number="A.2", blind=("0 + 1",),
        how="The left sides are the field with the coefficients (A.3) below, and its derivatives, at the nodes.")

    page.section("A.3", "The coefficients", ["equations.shape::coefficients", "equations.shape::coefficients_printed"])
    page.words("""Seven conditions for seven columns. They fall apart in two: {r_y} is {slope}, so three of them are
        for {a_2}, {a_3}, {a_6} alone.""", r_y=r_y, slope=a_2 + a_3 * x + a_6 * x**2, a_2=a_2, a_3=a_3, a_6=a_6)
    page.formulas_of([
        (a_2, r_y_i),
        (a_2 + half * a_3 + Quotient(l**2, node(4)) * a_6, r_y_j),
        (a_2 + l * a_3 + l**2 * a_6, r_y_k)],
        how="The left sides have the coefficients that solve (A.2).")
    page.words("""**First exercise**, five minutes. Solve the three lines for {a_3} and {a_6} before you read on. (The answer is in (A.3).)""",
               a_3=a_3, a_6=a_6)
    page.words("Four times the second line less the third is rid of {a_6}:", a_6=a_6)
    page.formula(3 * a_2 + l * a_3, 4 * r_y_j - r_y_k, how="As above.")
    page.words("""The first line gives {a_2}, this one {a_3}, the third {a_6}:""", a_2=a_2, a_3=a_3, a_6=a_6)
    page.formulas_of([(l * a_3, -(3 * r_y_i) + 4 * r_y_j - r_y_k), 
                      (l**2 * a_6, r_y_k - r_y_i - l * a_3, 2 * r_y_i - 4 * r_y_j + 2 * r_y_k)],
                     how="As above.")
    page.words("The other four conditions lie on the axis, where {y} is zero:", y=y)
    page.formulas_of([
        (a_0, r_i),
        (a_0 + half * a_1 + Quotient(l**2, node(4)) * a_4 + Quotient(l**3, node(8)) * a_5, r_j),
        (a_1 + l * a_4 + Quotient(3 * l**2, node(4)) * a_5, r_x_j),
        (a_0 + l * a_1 + l**2 * a_4 + l**3 * a_5, r_k)],
        how="As above.")
    page.words("""{a_0} is known. Eight times the second less the fourth, and three times the fourth less {factor} times the
        third, are rid of {a_5}; their sum is rid of {a_4}:""", a_0=a_0, a_4=a_4, a_5=a_5, factor=4 * l)
    page.formulas_of([
        (3 * l * a_1 + l**2 * a_4, 8 * r_j - 7 * r_i - r_k),
        (-(l * a_1) - l**2 * a_4, 3 * r_k - 3 * r_i - 4 * l * r_x_j),
        (2 * l * a_1, -(10 * r_i) + 8 * r_j + 2 * r_k - 4 * l * r_x_j)],
        how="As above.")
    page.words("So {a_1} is known; then {a_4} from the line before, and {a_5} from the fourth condition:", a_1=a_1, a_4=a_4, a_5=a_5)
    page.formulas_of([
        (l**2 * a_4, 3 * r_i - 3 * r_k + 4 * l * r_x_j - l * a_1, 8 * r_i - 4 * r_j - 4 * r_k + 6 * l * r_x_j),
        (l**3 * a_5, r_k - r_i - l * a_1 - l**2 * a_4, -(4 * r_i) + 4 * r_k - 4 * l * r_x_j)],
        how="As above.")
    page.words("Together:")
    page.formulas_of([
        (a_0, r_i),
        (a_1, -Quotient(5 * r_i - 4 * r_j - r_k + 2 * l * r_x_j, l)),
        (a_2, r_y_i),
        (a_3, -Quotient(3 * r_y_i - 4 * r_y_j + r_y_k, l)),
        (a_4, Quotient(8 * r_i - 4 * r_j - 4 * r_k + 6 * l * r_x_j, l**2)),
        (a_5, -Quotient(4 * r_i - 4 * r_k + 4 * l * r_x_j, l**3)),
        (a_6, Quotient(2 * r_y_i - 4 * r_y_j + 2 * r_y_k, l**2))],
        number="A.3", how="The left sides are the solution of (A.2) by a computer algebra system.")

    page.section("3", "The shape functions", ["equations.shape::S_i"])
    page.words("""Put (A.3) into (A.1) and collect what multiplies each nodal vector. {r_y_j} stands in {a_3} and {a_6}
        alone, so with {xi} and {eta}, its factor is""",
               r_y_j=r_y_j, a_3=a_3, a_6=a_6, xi=equation(a, Quotient(x, l)), eta=equation(b, Quotient(y, l)))
    page.formula(S_5, Quotient(node(4), l) * x * y - Quotient(node(4), l**2) * x**2 * y, l * b * (4 * a - 4 * a**2),
                 how="The left side is the derivative of (A.1), with the solution of (A.2), by the nodal vector.")
    page.words("The other six likewise:")
    page.formulas_of([
        (S_1, 1 - 5 * a + 8 * a**2 - 4 * a**3), (S_2, l * b * (1 - 3 * a + 2 * a**2)), (S_3, 4 * a - 4 * a**2),
        (S_4, l * a * (-node(2) + 6 * a - 4 * a**2)), (S_5, l * b * (4 * a - 4 * a**2)),
        (S_6, a - 4 * a**2 + 4 * a**3), (S_7, l * b * (-a + 2 * a**2))],
        number="3", how="As above, by each nodal vector.")
    page.figure("shapes", "Shape functions of positions and of the slope along, on the axis; of slopes across, over the place across")
    page.words("""Those of positions ({S_1}, {S_3}, {S_6}) are numbers, those of slopes lengths.""", S_1=S_1, S_3=S_3, S_6=S_6)
    page.exercise("""Cover (3). Which coefficients contain {r_x_j}? Collect its factor and write it as a product: it is
        {S_4}. Where does it vanish, and why must it vanish there?""", "1-shape", r_x_j=r_x_j, S_4=S_4)


def equation(left, right):
    """An equation within a line of words."""
    return Symbol(f"{left.tex()} = {right.tex()}", 0)
