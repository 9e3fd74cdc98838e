"""(A.4), (A.5) and (1)-(5): what the shape functions are good for; E1."""

import sympy

from ..element import field
from .algebra import Matrix, column
from .calculus import Determinant, Where
from .notation import PRODUCT, Named, Quotient, Symbol, Table, node
from .position import (NODAL, PAIRS, S, SHAPES, SOLVED, a, a_1, b, both, e, l, r, r_i, r_j, r_k, r_x_j, r_y_i, r_y_j, r_y_k, x, y)
from .symbols import I

S_1, S_2, S_3, S_4, S_5, S_6, S_7 = SHAPES


def write(page):
    """The rest of the chapter."""
    page.section("", "E1, an error in the paper")
    page.words("""The paper prints the last but one sign in the second line of (A.3) as a plus:""")
    printed = -Quotient(5 * r_i - 4 * r_j + r_k + 2 * l * r_x_j, l)
    page.formula(Named("printed", printed), a_1 - Quotient(2 * r_k, l),
                 how="Both sides are computed; the first term on the right is the solution of (A.2).")
    page.words("""With that coefficient the end of the element is not where its own node is, but at its mirror
        image:""")
    wrong = Symbol(r"\mathbf r_\text{printed}", both(field.polynomial(field.coefficients_printed())))
    page.formula(Where(wrong, l, 0), -r_k, how="The left side is (A.1) with the printed (A.3), at a place.")
    free = sympy.symbols("a_0:7")
    system = sympy.Matrix([[sympy.diff(value, k) for k in free] for value in field.nodal_values(field.polynomial(free))])
    page.words("""That (A.2) has one solution for any length, and no other, is what its determinant says:""")
    page.formula(Determinant(Symbol(r"\frac{\partial (\mathbf r^i, \mathbf r_y^i, \dots, \mathbf r_y^k)}{\partial (\mathbf a_0, \dots, \mathbf a_6)}",
                                    Matrix(system.tolist()), PRODUCT)), Quotient(l**8, node(64)),
                 how="""The left side is the determinant, for one component, of the derivatives of (A.2), taken of (A.1) with free
        coefficients.""")

    page.section("A.4", "Position by the nodal vectors", ["equations.shape::r_nodal"])
    page.words("""(A.1) with (A.3), sorted:""")
    page.formula(
        r,
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

