"""(22) and (23): motion of one element, and of several elements with constraints."""

import sympy
from flint import fmpq, fmpq_mat

from .algebra import DOF, NAMES, NODAL, Matrix, column, some_values, total
from .calculus import Derivative
from .force import Q_e, U
from .inertia import KINETIC, M, Q_w, WORK
from .notation import PRODUCT, Grouped, Reading, Symbol, Table, compute, node
from .symbols import PLANE

CLAMPED = 4  # constraints of the two pinned elements


class Numbers:
    """One element in a state of rational numbers, with the terms of (22)."""

    def __init__(self, seed, first=None):
        self.values = {"x": fmpq(0), "y": fmpq(0)} | some_values(seed)
        if first is not None:
            self.values |= {"e1": first[0], "e2": first[1]}
        self.M = self.of(M.meaning)
        self.force = self.gradient(U.meaning)
        self.weight = self.gradient(WORK)

    def of(self, meaning):
        """Value of a matrix of polynomials."""
        return meaning.each(lambda entry: entry(*[self.values[name] for name in NAMES]))

    def gradient(self, energy, at=None):
        """Derivative of an energy by the nodal coordinates, or by their rates where `at` gives these."""
        place = self.values | dict(zip(NODAL, at or self.e))
        return column([energy.derivative(name)(*[place[n] for n in NAMES]) for name in NODAL])

    def rate_of_momentum(self, e_dot, e_ddot):
        """d/dt of dT/de_dot; T is quadratic in the rates, so that its derivative is linear in them."""
        return self.gradient(KINETIC, [v + a for v, a in zip(e_dot, e_ddot)]) - self.gradient(KINETIC, e_dot)

    @property
    def e(self):
        """The nodal coordinates."""
        return [self.values[name] for name in NODAL]


def solve(matrix, right):
    """Solution of linear equations in rational numbers."""
    solution = fmpq_mat(matrix.rows).solve(fmpq_mat(right.rows))
    return Matrix(solution.tolist())


def rates(seed):
    """Fourteen rational numbers."""
    return [some_values(seed)[name] for name in NODAL]


class Pinned:
    """Two elements: the first is hinged to the ground at its node i, the second at its node i to node k of the first.

    The motion is found in the coordinates that the pins leave free. The forces in the pins follow from the momentum of the
    second element and of both.
    """

    def __init__(self):
        one = Numbers(11)
        two = Numbers(12, one.e[10:12])
        self.elements = (one, two)
        self.q = one.e + two.e
        zero = Matrix([[fmpq(0)] * DOF for _ in range(DOF)])
        self.m = Matrix([a + b for a, b in zip(one.M.rows, zero.rows)] + [a + b for a, b in zip(zero.rows, two.M.rows)])
        self.force = Matrix(one.force.rows + two.force.rows)
        self.weight = Matrix(one.weight.rows + two.weight.rows)
        # Coordinates 10 and 11 are the end of the first element, 14 and 15 the beginning of the second.
        free = [k for k in range(2 * DOF) if k not in (0, 1, 14, 15)]
        carry = Matrix([[fmpq(int(k == n or (k in (14, 15) and n == k - 4))) for n in free] for k in range(2 * DOF)])
        own = solve(carry.transpose() @ self.m @ carry, carry.transpose() @ (self.weight - self.force))
        self.q_ddot = carry @ own
        rate = self.m @ self.q_ddot - self.weight

        def resultant(first):
            return [total(rate[first + k + i, 0] for k in (0, 4, 10)) for i in PLANE]

        one_rate, two_rate = resultant(0), resultant(DOF)
        self.multipliers = column([-(a + b) for a, b in zip(one_rate, two_rate)] + two_rate)
        self.Phi_q = Matrix([[fmpq(self.entry(row, k)) for k in range(2 * DOF)] for row in range(CLAMPED)])

    @staticmethod
    def entry(row, k):
        """Derivative of a row of Phi by coordinate k."""
        if row < 2:
            return int(k == row)
        return int(k == 8 + row) - int(k == 12 + row)

    def vector(self, k):
        """The nodal vector whose first component is coordinate k."""
        return column(self.q[k:k + 2])


def write(page):
    """The chapter."""
    page.heading("6 Motion")
    page.section("22", "One element", ["equations.motion::residual", "equations.motion::acceleration"])
    element, v, a = Numbers(3), rates(4), rates(5)
    e_ddot = Symbol(r"\ddot{\mathbf e}", column(a))
    numbers = {symbol: Symbol(symbol.text, element.of(symbol.meaning)) for symbol in (M, Q_e, Q_w)}
    M_, Q_e_, Q_w_ = numbers[M], numbers[Q_e], numbers[Q_w]
    page.words("""Lagrange's equations turn energies into motion: the rate of the momentum, less what the kinetic
        energy gains by position, plus what the strain energy resists, less what the loads' work {W} gives. {T} does
        not depend on position here. For any state and any acceleration:""",
               W=Symbol("W", 0), T=Symbol("T", 0))
    momentum, none, elastic, loads = (Symbol(text, meaning, PRODUCT) for text, meaning in (
        (r"\frac{\mathrm d}{\mathrm dt} \frac{\partial T}{\partial \dot{\mathbf e}}", element.rate_of_momentum(v, a)),
        (r"\frac{\partial T}{\partial \mathbf e}", column([fmpq(0)] * DOF)),
        (r"\frac{\partial U}{\partial \mathbf e}", element.force),
        (r"\frac{\partial W}{\partial \mathbf e}", element.weight)))
    page.formula(
        momentum - none + elastic - loads, M_ * e_ddot + Q_e_ - Q_w_, blind=(f"2 {none.text}", f"sign of {(-none).tex()}"),
        how="""The left side is differentiated from the energies, along a motion; the right side holds the mass
        matrix and the force of virtual work.""")
    page.words("On a motion it is zero:")
    moving = solve(M_.meaning, element.weight - element.force)
    e_ddot = Symbol(r"\ddot{\mathbf e}", moving)
    page.formula(M_ * e_ddot + Symbol(r"\mathbf Q_e(\Delta T)", Q_e_.meaning), Q_w_, number="22",
                 how="The acceleration solves the equations above, with the derivatives of the energies.")
    page.words("""Multiply by the velocity, and the power of the loads is what the energies gain. So a program can
        watch the sum of its energies; but a kept sum is no evidence of accuracy.""")
    e_dot = Symbol(r"\dot{\mathbf e}", column(v))
    T_dot = Symbol(r"\dot T", dot(element.gradient(KINETIC, v), moving))
    U_dot = Symbol(r"\dot U", dot(element.force, e_dot.meaning))
    page.formula(T_dot + U_dot, Q_w_.T * e_dot,
                 how="The left side is the chain rule along the motion of (22).")

    page.section("23", "Elements held together",
                 ["equations.motion::system_residual", "equations.motion::system_acceleration",
                  "equations.motion::constraint_force", "equations.motion::constraint_force_printed"])
    page.words("""A structure is several elements, whose nodal coordinates stand below each other in one column {q},
        and conditions {Phi}: a pin says that two points are one, a support that one stays. The Lagrangian gets the
        term {term} with multipliers {lam} (the paper's symbol, which is also Lamé's constant: E5). Its derivative
        is the force that holds the pins, and that force does no work where the conditions are kept:""",
               q=Symbol(r"\mathbf q", 0), Phi=Symbol(r"\boldsymbol\Phi(\mathbf q) = \mathbf 0", 0),
               term=Symbol(r"\boldsymbol\lambda^{\mathsf T} \boldsymbol\Phi", 0), lam=Symbol(r"\boldsymbol\lambda", 0))
    names = sympy.symbols("q_1:4")
    functions = [sympy.Function(f"Phi_{k}")(*names) for k in (1, 2)]
    many = column(sympy.symbols("lambda_1:3"))
    Phi_q = Symbol(r"\boldsymbol\Phi_q", Matrix([[f.diff(name) for name in names] for f in functions]))
    multipliers = Symbol(r"\boldsymbol\lambda", many)
    dq = Symbol(r"\delta\mathbf q", column(sympy.symbols("d_1:4")))
    Phi = Symbol(r"\boldsymbol\Phi", column(functions))
    page.formulas_of([
        (Derivative(multipliers.T * Phi, r"\mathbf q", names).T, Phi_q.T * multipliers),
        (dq.T * Phi_q.T * multipliers, multipliers.T * Grouped(Phi_q * dq))],
        how="""The conditions are two arbitrary functions of three coordinates. The left side above is
        differentiated, below multiplied out.""")
    page.words("""**E4, an error in the paper.** It prints {printed}, without the transpose. With fewer conditions
        than coordinates that product does not exist. With as many it is the wrong force. A point in the plane that
        is held twice on its first axis may still move along it; the right force does not act in this direction, the
        printed one does:""", printed=without_meaning(Phi_q * multipliers))
    twice = Symbol(r"\boldsymbol\Phi_\text{twice}", Matrix([[0, 1], [0, 1]]))
    along = Table([1], [0])
    page.formulas_of([
        (twice, Table([0, 1], [0, 1])),
        (along.T * twice.T * multipliers, node(0)),
        (along.T * twice * multipliers, Table([0], [1]).T * multipliers)],
        how="The matrix holds the derivatives of the two equal conditions.",
        blind=(r"2 \boldsymbol\Phi_\text{twice}", r"2 \boldsymbol\lambda", "1 + 1"))
    page.words("""Now two elements: the first hinged to the ground, the second to the end of the first.""")
    pinned = Pinned()
    ground = Symbol(r"\mathbf r_\text{ground}", pinned.vector(0))
    A_i, A_k, B_i = (Symbol(text, pinned.vector(k)) for text, k in
                     ((r"\mathbf r_\text{first}^i", 0), (r"\mathbf r_\text{first}^k", 10), (r"\mathbf r_\text{second}^i", 14)))
    m, q_ddot, f = (Symbol(text, meaning) for text, meaning in (
        (r"\mathbf m", pinned.m), (r"\ddot{\mathbf q}", pinned.q_ddot), (r"\mathbf f", pinned.weight)))
    forces, lam = Symbol(r"\mathbf k(\Delta T)\,\mathbf q", pinned.force), Symbol(r"\boldsymbol\lambda", pinned.multipliers)
    rows = Symbol(r"\boldsymbol\Phi_q", pinned.Phi_q)
    page.formulas_of([
        (Symbol(r"\boldsymbol\Phi(\mathbf q)", column([fmpq(0)] * 4)), Table([A_i - ground], [A_k - B_i])),
        (m * q_ddot + forces + rows.T * lam, f),
        (rows * q_ddot, Symbol(r"\mathbf 0", column([fmpq(0)] * 4)))],
        number="23", blind=(r"2 \boldsymbol\Phi_q", r"2 \ddot{\mathbf q}"),
        how="""The acceleration is found without multipliers, by Lagrange's equations in the 24 coordinates that the
        pins leave free; the multipliers from the momentum of the second element and of both.""")
    page.words("""The paper's second line is {paper}: conditions that may be curved in {q} and may change with time {t}. Here
        they are linear in {q} and do not contain {t}: pins and supports hold points, and a point is linear in {q} by (1).
        So {rows} is constant, and the conditions' second derivative by time is the last line without further terms.
        For others it would have {curved} and the second derivative by {t} on its right side.""",
               paper=Symbol(r"\boldsymbol\Phi(\mathbf q, t) = \mathbf 0", 0), q=Symbol(r"\mathbf q", 0), t=Symbol("t", 0),
               rows=rows, curved=Symbol(r"-(\boldsymbol\Phi_q \dot{\mathbf q})_q \dot{\mathbf q}", 0))
    page.words("""{kq} is the elements' forces (19), one below the other. The last line is the conditions
        differentiated twice by time; together with the second it gives accelerations and multipliers by one system
        of linear equations. A multiplier is the force with which the first named body is held back by the pin. Here a pin is
        {here}; the values to check against (`fixtures/structure.json`) and this project's scenes take second rod less first,
        {there}. That turns the sign of a pin's multipliers and of its rows in {rows}, and neither their product nor the
        motion.""", kq=forces, rows=rows, here=A_k - B_i, there=B_i - A_k)


def dot(a, b):
    """Scalar product of two columns."""
    return (a.transpose() @ b)[0, 0]


def without_meaning(formula):
    """A formula without a value; it must fail to compute."""
    try:
        compute([formula], Reading())
    except ValueError:
        return formula
    raise AssertionError(f"must have no value: {formula.tex()}")
