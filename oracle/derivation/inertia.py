"""(6), (7), the mass matrix written out, and the weight."""

from ..element import field
from . import symbols as Y
from .algebra import GEN, NODAL, column, hessian, normal, over_volume, total
from .calculus import Integral, Kronecker
from .notation import Quotient, Symbol, Table, node
from .symbols import HALF, I, ONE, PLANE, RING, e_dot, h, l, r_dot, rho, w, xi, y


def by_coefficients():
    """T from the coefficients of (A.1) and the integrals of products of its monomials, without shape functions."""
    def moment(p, q):
        return over_volume(monomial(p) * monomial(q))

    energy = RING.constant(0)
    for i in PLANE:
        rates = [Y.in_nodes(k, NODAL, i) for k in field.coefficients()]
        for p, a in zip(field.MONOMIALS, rates):
            for q, b in zip(field.MONOMIALS, rates):
                energy += a * b * moment(p, q) * GEN["rho"] * HALF
    return normal(energy)


def monomial(expression):
    """A monomial of (A.1) in the ring."""
    return Y.lift(expression, (field.x, field.y, field.l))


def weights_work():
    """Work of the weight, the integral of rho g . r, from the polynomial."""
    g = [GEN["g1"], GEN["g2"]]
    return normal(over_volume(total(g[i] * Y.r_components()[i] for i in PLANE) * GEN["rho"]))


KINETIC = by_coefficients()
WORK = weights_work()
T = Symbol("T", KINETIC)
M = Symbol(r"\mathbf M", hessian(KINETIC, NODAL))
g = Symbol(r"\mathbf g", column([GEN["g1"], GEN["g2"]]))
Q_w = Symbol(r"\mathbf Q_w", column([WORK.derivative(name) for name in NODAL]))
S = Y.S


def write(page):
    """The chapter."""
    page.heading("2 Inertia: a mass matrix that never changes")
    page.words("""The element is a bar of the length {l}, the height {h} (in the plane) and the width {w} (across
        it). A volume integral is three integrals, and the sum of all volume elements is the volume:""", l=l, h=h, w=w)
    page.formula(Integral("V", Symbol("1", ONE)), l * h * w,
                 how="""The left side is the integral from zero to l along the element, over its height about the
        axis, times its width.""")

    page.section("6", "Kinetic energy", ["equations.inertia::T_integral", "equations.inertia::T"])
    page.words("""Half the mass times the square of the velocity, summed over all points. By (5) the velocity is {Se},
        and its square {square}. {e_dot} does not depend on the place and is taken out of the integral on both sides;
        a matrix {M} is left.""", M=M, Se=S * e_dot, e_dot=e_dot, square=e_dot.T * S.T * S * e_dot)
    page.formula(T, node("1/2") * Integral("V", rho * r_dot.T * r_dot), node("1/2") * e_dot.T * M * e_dot, number="6",
                 how="""The left side is summed from the coefficients (A.3) and the integrals of products of the
        monomials of (A.1).""")

    page.section("7", "The mass matrix", ["equations.inertia::M"])
    page.formula(M, Integral("V", rho * S.T * S), number="7",
                 how="The left side holds the second derivatives of that sum by the nodal velocities.")
    page.words("""By (2) it has seven times seven blocks, each a number times {I}: the block of two nodal vectors is
        the integral of the product of their shape functions. Once by hand, for the middle's position with itself.
        Multiply out, then integrate each power, whose mean over the length is one over its exponent plus one:""", I=I)
    S_2, S_3 = (Symbol(f"S_{k}", Y.SHAPES[k - 1]) for k in (2, 3))
    page.formula(
        Integral("V", rho * S_3 * S_3), rho * h * w * Integral("l", (4 * xi - 4 * xi**2)**2),
        rho * h * w * Integral("l", 16 * xi**2 - 32 * xi**3 + 16 * xi**4),
        rho * l * h * w * (node("16/3") - node("32/4") + node("16/5")), node("8/15") * rho * l * h * w,
        how="The left side has the shape functions derived in (3).")
    page.words("""And for a slope across with itself, at the beginning. Its shape function has the factor {y}, whose square's
        integral over the section is {second}:""", y=y, second=Quotient(w * h**3, node(12)))
    page.formula(
        Integral("V", rho * S_2 * S_2), rho * Quotient(w * h**3, node(12)) * Integral("l", (1 - 3 * xi + 2 * xi**2)**2),
        rho * Quotient(w * h**3, node(12)) * Integral("l", 1 - 6 * xi + 13 * xi**2 - 12 * xi**3 + 4 * xi**4),
        rho * Quotient(w * h**3, node(12)) * l * (1 - node(3) + node("13/3") - node(3) + node("4/5")),
        rho * l * h * w * Quotient(h**2, node(90)),
        how="As above.")
    page.words("""A position with a slope across gives zero, as {y} and minus {y} cancel. All blocks, where the sign {sign} says that each
        number is to be multiplied by {I}:""", y=y, I=I, sign=Symbol(r"\otimes", 0))
    page.formula(M, rho * l * h * w * Kronecker(mass_table(), I),
                 how="The left side holds the second derivatives of the kinetic energy.")
    page.words("""{M} is symmetric, and constant: no rotation enters, so there are no centrifugal and Coriolis
        forces to write down. A test: the column {d} that moves every point by one along the first axis has ones
        for the first components of the three positions and zeros for all else. It must feel the whole mass.""", M=M, d=MOVE)
    page.formula(MOVE.T * M * MOVE, rho * l * h * w, how="The left side is computed with the matrix above.")
    page.exercise("""Integrate the first block, that of the beginning's position with itself.""", "2-mass")

    page.section("", "The weight", ["equations.inertia::Q_w_gravity"])
    page.words("""A generalized force is the derivative of work by the nodal coordinates. The weight's work is the
        integral of density times {g} times position; with (1), its derivative is""", g=g)
    zero, mass = Y.O, rho * l * h * w
    sixth, middle = Quotient(g, node(6)), Quotient(2 * g, node(3))
    page.formula(Q_w, Integral("V", rho * S.T * g),
                 mass * Table([sixth], [zero], [middle], [zero], [zero], [sixth], [zero]),
                 how="""The left side is the derivative of the work, integrated from the polynomial.""", blind=(r"2 \mathbf 0",))
    page.words("""The ends carry a sixth of the weight each and the middle two thirds: Simpson's rule. The slopes
        carry nothing, as the weight of a straight section pulls at its middle.""")


def mass_table():
    """The blocks of M over the mass, seven rows in the order of (4)."""
    o, square, length = node(0), (lambda n: Quotient(h**2, node(n))), (lambda n: Quotient(l, node(n)))
    f = node
    return Table(
        [f("3/35"), o, f("1/15"), -length(70), o, f("1/70"), o],
        [o, square(90), o, o, square(180), o, -square(360)],
        [f("1/15"), o, f("8/15"), o, o, f("1/15"), o],
        [-length(70), o, o, Quotient(2 * l**2, node(105)), o, length(70), o],
        [o, square(180), o, o, Quotient(2 * h**2, node(45)), o, square(180)],
        [f("1/70"), o, f("1/15"), length(70), o, f("3/35"), o],
        [o, -square(360), o, o, square(180), o, square(90)])


MOVE = Symbol(r"\mathbf u_\text{move}", column([int(k in (0, 4, 10)) for k in range(14)]))
