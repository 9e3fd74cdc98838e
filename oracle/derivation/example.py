"""A worked example in numbers: from (A.1) to the first step of a pendulum."""

import sympy
from flint import fmpq, fmpq_mat

from ..element import field
from ..fixtures.fixture import from_sympy
from . import symbols as Y
from .algebra import NAMES, NODAL, column
from .force import Q_e
from .inertia import M, Q_w
from .notation import PRODUCT, Decimal, Quotient, Symbol, Table, node
from .tangent import BENDING, LEVEL

LENGTH, SIDE, DENSITY, YOUNG, GRAVITY = fmpq(1), fmpq(1, 50), fmpq(7750), fmpq(2 * 10**8), fmpq(-49, 5)
STEP = fmpq(1, 10**5)
VALUES = {name: fmpq(0) for name in NAMES} | {
    "l": LENGTH, "per_l": 1 / LENGTH, "c": fmpq(1), "h": SIDE, "w": SIDE, "rho": DENSITY, "mu": YOUNG / 2, "g2": GRAVITY}
# The first node is pinned.
FREE = range(2, 14)


def evaluated(meaning, nodal):
    """Numbers of a matrix of polynomials, at nodal coordinates."""
    place = VALUES | dict(zip(NODAL, nodal))
    return meaning.each(lambda entry: entry(*[place[name] for name in NAMES]))


def read(pairs):
    """Nodal coordinates that (A.2) reads off a field of two components."""
    values = zip(*[field.nodal_values(component) for component in pairs])
    return [in_numbers(value) for pair in values for value in pair]


def in_numbers(expression, **more):
    """A number from an expression of sympy, for the length of this element."""
    places = {sympy.Symbol(name): value for name, value in more.items()} | {field.l: 1}
    return from_sympy(sympy.Rational(expression.subs(places)))


def solved(nodal):
    """Columns of the coefficients for nodal coordinates, as the oracle solves (A.2)."""
    components = [{str(name): sympy.Rational(str(value)) for name, value in zip(field.NODAL, nodal[i::2])} for i in Y.PLANE]
    return [column([in_numbers(expression, **values) for values in components]) for expression in field.coefficients()]


class FirstStep:
    """One element from horizontal rest, pinned at its first node, by the velocity form of Verlet's rule."""

    def __init__(self):
        self.e_0 = read((field.x, field.y))
        self.mass = evaluated(M.meaning, self.e_0)
        self.weight = evaluated(Q_w.meaning, self.e_0)
        assert all(force == 0 for (force,) in evaluated(Q_e.meaning, self.e_0).rows)
        self.start = self.acceleration(column([fmpq(0)] * 14))
        self.moved = [a * STEP * STEP / 2 for a in self.start]
        self.linear = evaluated(LEVEL, self.e_0) @ column(self.moved)
        self.then = self.acceleration(self.linear)
        exact = self.acceleration(evaluated(Q_e.meaning, [e + u for e, u in zip(self.e_0, self.moved)]))
        self.left_out = abs(float((exact[11] - self.then[11]) / exact[11]))
        self.velocity = [(a + b) * STEP / 2 for a, b in zip(self.start, self.then)]

    def acceleration(self, force):
        """Nodal accelerations under the weight and an elastic force, the first node at rest."""
        right = [[self.weight[k, 0] - force[k, 0]] for k in FREE]
        solution = fmpq_mat([[self.mass[i, j] for j in FREE] for i in FREE]).solve(fmpq_mat(right)).tolist()
        return [fmpq(0), fmpq(0), *(value for (value,) in solution)]

    def multiplier(self):
        """What is missing in the first node's two equations at the start."""
        rate = self.mass @ column(self.start)
        return column([self.weight[k, 0] - rate[k, 0] for k in (0, 1)])


def vector(values, k):
    """The nodal vector whose first component is coordinate k."""
    return column(values[k:k + 2])


def write(page):
    """The chapter."""
    run = FirstStep()
    l, h, w, rho, mu, E = (Symbol(text, value) for text, value in (
        ("l", LENGTH), ("h", SIDE), ("w", SIDE), (r"\rho", DENSITY), (r"\mu", YOUNG / 2), ("E", YOUNG)))
    g, dt = Symbol(r"\mathbf g", column([fmpq(0), GRAVITY])), Symbol(r"\Delta t", STEP)
    half = node("1/2")
    page.heading("9 In numbers: the first step of a pendulum")
    page.rust("equations.shape::coefficients", "equations.shape::S", "equations.inertia::M", "equations.inertia::Q_w_gravity",
              "equations.force::tangent", "equations.motion::acceleration")
    page.words("""The pendulum of the paper's Table 1, without heat, as one element: a soft, slender rod that is held
        level, pinned at its first node, and let go. Numbers are exact, in SI units; as {l} is one, it is not written
        from here on.""", l=l)
    page.formulas_of([(l, node(1)), (h, w, Decimal("0.02")), (rho, node(7750)), (E, Decimal("2e8")), (g, Table([0], [Decimal("-9.8")])),
                      (rho * l * h * w, Decimal("3.1")), (mu, Quotient(E, node(2)), Decimal("1e8"))],
                     how="The data; the mass; (17) without Poisson's ratio, when the other constant of Lamé is zero.")
    page.words("""**Nodal vectors.** At the start {r} is {place}, and (A.2) reads off it""", r=Symbol(r"\mathbf r", 0),
               place=Symbol(r"\begin{bmatrix}x & y\end{bmatrix}^{\mathsf T}", 0))
    zero, half_way, one, up = (Table([a], [b]) for a, b in ((0, 0), (half, 0), (1, 0), (0, 1)))
    names = (r"\mathbf r^i", r"\mathbf r_y^i", r"\mathbf r^j", r"\mathbf r_x^j", r"\mathbf r_y^j", r"\mathbf r^k", r"\mathbf r_y^k")
    r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k = [Symbol(text, vector(run.e_0, 2 * n)) for n, text in enumerate(names)]
    page.formulas_of([(r_i, zero), (r_j, half_way), (r_x_j, one), (r_k, one), (r_y_i, r_y_j), (r_y_j, r_y_k), (r_y_k, up)],
                     how="The left sides are read off the field.")
    page.words("""**Coefficients.** (A.3) gives back what was put in, {a_1} among them, and zero for all of higher degree:""",
               a_1=Symbol(r"\mathbf a_1", 0))
    coefficients = solved(run.e_0)
    a_1, a_4 = (Symbol(rf"\mathbf a_{n}", coefficients[n]) for n in (1, 4))
    page.formulas_of([
        (a_1, 4 * half_way + one - 2 * one, one), (a_4, -4 * half_way - 4 * one + 6 * one, zero)],
        how="The left sides are the oracle's coefficients.")
    page.words("""**A point.** A quarter along the axis, at {xi}, the shape functions (3) are""", xi=Symbol(r"\xi = \tfrac{1}{4}", 0))
    quarter = {"x": sympy.Rational(1, 4), "y": 0}
    shapes = [Symbol(f"S_{n}", in_numbers(shape, **quarter)) for n, shape in enumerate(field.shape_functions(), 1)]
    page.formulas_of([(shapes[k], node(value)) for k, value in ((0, "3/16"), (2, "3/4"), (3, "-3/16"), (5, "1/16"))],
                     how="The left sides are the shape functions derived in (3), at the place.")
    r = Symbol(r"\mathbf r", column([fmpq(1, 4), fmpq(0)]))
    page.words("and (1) finds the point where it should be:")
    page.formula(r, shapes[0] * r_i + shapes[2] * r_j + shapes[3] * r_x_j + shapes[5] * r_k, Table([node("1/4")], [0]),
                 how="The left side is the place itself.",
                 blind=(f"2 {shapes[0].text}", f"2 {r_i.text}", f"sign of {(shapes[0] * r_i).tex()}"))
    page.words("""**Forces.** Nothing is strained, so there are no elastic forces, and {Q} is as under (7): a sixth, two
        thirds and a sixth of the weight. **Acceleration.** The first node is held: {held}. The slopes across do not
        take part, as the mass matrix has zeros between them and the rest. Three of the rows of (22) are left, here
        over the mass:""", Q=Symbol(r"\mathbf Q_w", 0), held=Symbol(r"\ddot{\mathbf r}^i = \mathbf 0", 0))
    acc_j, acc_x, acc_k = (Symbol(text, vector(run.start, n)) for text, n in
                           ((r"\ddot{\mathbf r}^j", 4), (r"\ddot{\mathbf r}_x^j", 6), (r"\ddot{\mathbf r}^k", 10)))
    none = Symbol(r"\mathbf 0", column([fmpq(0), fmpq(0)]))
    page.formulas_of([
        (node("8/15") * acc_j + node("1/15") * acc_k, node("2/3") * g),
        (node("2/105") * acc_x + node("1/70") * acc_k, none),
        (node("1/15") * acc_j + node("1/70") * acc_x + node("3/35") * acc_k, node("1/6") * g)],
        how="The accelerations solve the equations of all free coordinates.")
    page.words("""The first two give the middle's vectors by the end's; put into the third, they leave one unknown:""")
    page.formulas_of([
        (acc_j, node("5/4") * g - node("1/8") * acc_k), (acc_x, -(node("3/4") * acc_k)),
        (node("1/15") * (node("5/4") * g - node("1/8") * acc_k) - node("1/70") * (node("3/4") * acc_k) + node("3/35") * acc_k,
         node("1/6") * g),
        (node("1/15") * acc_k, node("1/12") * g)],
        how="As above.")
    page.words("So the accelerations are")
    page.formulas_of([
        (acc_k, node("5/4") * g, Table([0], [Decimal("-12.25")])),
        (acc_j, node("35/32") * g, Table([0], [Decimal("-10.71875")])),
        (acc_x, -(node("15/16") * g), Table([0], [Decimal("9.1875")]))],
        how="As above.")
    page.words("""A rigid rod would start with one and a half of {g} at its end. This one does not know yet that it is
        stiff: forces come from strains, and there are none yet. The pin's multiplier is what the first two rows of
        (23) lack:""", g=g)
    lam = Symbol(r"\boldsymbol\lambda", run.multiplier())
    mass = rho * l * h * w
    page.formula(lam, mass * (node("1/6") * g - node("1/15") * acc_j + node("1/70") * acc_x - node("1/70") * acc_k),
                 node("1/16") * mass * g, Table([0], [Decimal("-1.89875")]),
                 how="The left side is the residual of the first two equations.")
    page.words("""The support pushes up with 1.89875 N, a sixteenth of the weight. **The step.** Verlet's rule moves
        every coordinate by half the squared step times its acceleration. With {dt}:""", dt=dt)
    moved = Symbol(r"\mathbf r^k(\Delta t)", column([e + u for e, u in zip(run.e_0[10:12], run.moved[10:12])]))
    page.formulas_of([(dt, Decimal("1e-5")), (moved, r_k + half * dt**2 * acc_k, Table([1], [Decimal("-6.125e-10")]))],
                     how="The left side is the coordinate after the step.")
    page.words("""Now there are strains. The displacements have second components only, so the seven coordinates that
        bend take part; the tangent at rest tells the forces, here for displacements of the size {size} as unit:""", size=half * dt**2 * g)
    shape = Table([0], [node("35/32")], [-(node("15/16") * Quotient(node(1), Y.l))], [node("5/4")], [0], [0], [0])
    forces = [-node("17/4"), node("5/2"), -(node("7/4") * Y.l), node("7/4"), node("13/16") * Y.l, node("1/4") * Y.l, node("3/16") * Y.l]
    page.formula(BENDING * shape, Quotient(Y.mu * Y.h * Y.w, Y.l) * Table(*[[force] for force in forces]),
                 how="The left side is the product of the matrix written out above with the accelerations found.")
    page.words("""The forces on the three positions add up to nothing, as they must. (The tangent leaves out what is
        quadratic in the displacement: a relative error of {error} in the acceleration.) They change the
        accelerations, by the same three rows of the mass matrix. Over the mass, with {f} for {unit}:""",
               error=Symbol(power(run.left_out), 0), f=Symbol(r"\mathbf a_\text{step}", 0), unit=Quotient(mu, rho) * half * dt**2 * g)
    step = Symbol(r"\mathbf a_\text{step}", column([fmpq(0), VALUES["mu"] / DENSITY * STEP * STEP / 2 * GRAVITY]))
    change = [b - a for a, b in zip(run.start, run.then)]
    by_j, by_x, by_k = (Symbol(text, vector(change, n), PRODUCT) for text, n in
                        ((r"\delta\ddot{\mathbf r}^j", 4), (r"\delta\ddot{\mathbf r}_x^j", 6), (r"\delta\ddot{\mathbf r}^k", 10)))
    page.formulas_of([
        (step, Quotient(mu, rho) * half * dt**2 * g),
        (node("8/15") * by_j + node("1/15") * by_k, -(node("5/2") * step)),
        (node("2/105") * by_x + node("1/70") * by_k, node("7/4") * step),
        (node("1/15") * by_j + node("1/70") * by_x + node("3/35") * by_k, -(node("7/4") * step)),
        (by_k, -(node("165/4") * step))],
        how="The changes solve the equations of all free coordinates.")
    page.words(f"""The last line follows as before. The end's acceleration is now {float(run.then[11]):.7f} m/s² in the
        second component, and its velocity, which takes the mean of both accelerations, {float(run.velocity[11]) *
        1e4:.8f} ten-thousandths of 1 m/s:""")
    then = Symbol(r"\ddot{\mathbf r}^k(\Delta t)", vector(run.then, 10))
    velocity = Symbol(r"\dot{\mathbf r}^k(\Delta t)", vector(run.velocity, 10))
    page.formulas_of([(then, acc_k + by_k), (velocity, half * dt * (acc_k + then))],
                     how="The left sides are computed coordinate by coordinate.")
    page.words("""That is a step. The program prints the same: [sheet 4](../teaching/4-first-step.md) has the scene, and asks for more.""")


def power(value):
    """A small number as TeX, one digit."""
    mantissa, exponent = f"{value:.0e}".split("e")
    return rf"{mantissa} \cdot 10^{{{int(exponent)}}}"
