"""Symbols of the page with their meanings, each found another way than the formula that states it."""

from functools import cache

import sympy
from flint import fmpq

from ..element import field
from .algebra import (GEN, NODAL, RING, Matrix, column, hessian, lift, normal, over_volume,
                      replace, total)
from .calculus import Function
from .notation import PRODUCT, Symbol

PLANE = range(2)
HALF = fmpq(1, 2)
ZERO, ONE = RING.constant(0), RING.constant(1)

# Numbers of the ring.
x, y, l, h, w = (Symbol(name, GEN[name]) for name in ("x", "y", "l", "h", "w"))
xi = Symbol(r"\xi", GEN["x"] * GEN["per_l"])
rho, lam, mu = Symbol(r"\rho", GEN["rho"]), Symbol(r"\lambda", GEN["lam"]), Symbol(r"\mu", GEN["mu"])
heat = Symbol(r"\alpha_T \Delta T", GEN["heat"], PRODUCT)
theta = Symbol(r"\theta", None)
COS, SIN = Symbol(r"\cos\theta", GEN["c"]), Symbol(r"\sin\theta", GEN["s"])
ANGLE = {r"\cos": COS, r"\sin": SIN}
I = Symbol(r"\mathbf I", Matrix([[1, 0], [0, 1]]))
O = Symbol(r"\mathbf 0", column([0, 0]))


def cosine():
    """cos theta."""
    return Function(r"\cos", theta, ANGLE)


def sine():
    """sin theta."""
    return Function(r"\sin", theta, ANGLE)


# The element of the ring.


def shape_functions():
    """S_1 ... S_7, from (A.1) and (A.2)."""
    return [lift(shape, (field.x, field.y, field.l)) for shape in field.shape_functions()]


SHAPES = shape_functions()


def blocks(functions):
    """[f_1 I ... f_7 I]."""
    return Matrix([[f if i == j else ZERO for f in functions for j in PLANE] for i in PLANE])


def variables(names):
    """A column of the ring's variables."""
    return column([GEN[name] for name in names])


def in_nodes(expression, names, i):
    """An expression in one component's nodal values as a polynomial in component i of the variables `names`."""
    own = {value: sympy.Symbol(names[2 * k + i]) for k, value in enumerate(field.NODAL)}
    return lift(sympy.expand(expression.subs(own)), (field.x, field.y, field.l, *own.values()))


def polynomial_position(names):
    """The field (A.1) with its coefficients, component by component."""
    return [in_nodes(field.polynomial(field.coefficients()), names, i) for i in PLANE]


def slope(name):
    """The slope r_x or r_y."""
    return Symbol(rf"\mathbf r_{name}", column([f.derivative(name) for f in polynomial_position(NODAL)]))


S = Symbol(r"\mathbf S", blocks(SHAPES))
S_x = Symbol(r"\mathbf S_x", blocks([f.derivative("x") for f in SHAPES]))
S_y = Symbol(r"\mathbf S_y", blocks([f.derivative("y") for f in SHAPES]))
e, e_dot = Symbol(r"\mathbf e", variables(NODAL)), Symbol(r"\dot{\mathbf e}", variables(NODAL))
r = Symbol(r"\mathbf r", column(polynomial_position(NODAL)))
r_dot = Symbol(r"\dot{\mathbf r}", column(polynomial_position(NODAL)))
r_x, r_y = slope("x"), slope("y")
c, s = GEN["c"], GEN["s"]


def row(i, name):
    """Row i of S differentiated by x or y."""
    source = {"x": S_x, "y": S_y}[name]
    meaning = Matrix([source.meaning.rows[i - 1]]) if isinstance(i, int) else None
    return Symbol(rf"\mathbf S_{{{i}{name}}}", meaning)


def own_to_global(polynomial):
    """A function of x and y as one of the initial position, whose components are again named x and y."""
    return replace(polynomial, x=c * GEN["x"] + s * GEN["y"], y=c * GEN["y"] - s * GEN["x"])


def global_to_own(polynomial):
    """A function of the initial position as one of x and y."""
    return replace(polynomial, x=c * GEN["x"] - s * GEN["y"], y=s * GEN["x"] + c * GEN["y"])


def deformation_gradient(position):
    """dr/dr_0 by differentiating r as a function of r_0, without the chain rule."""
    of_place = [own_to_global(component) for component in position]
    return Matrix([[normal(global_to_own(component.derivative(name))) for name in ("x", "y")] for component in of_place])


J = Symbol(r"\mathbf J", deformation_gradient(polynomial_position(NODAL)))
J_0 = Symbol(r"\mathbf J_0", Matrix([[c, -s], [s, c]]))


def initial_nodes():
    """Nodal values (A.2) of the straight element r_0 = origin + R (x, y) with the origin (g1, g2)."""
    X, Y = field.x, field.y
    names = sympy.symbols("g1 g2 c s")
    fields = (names[0] + names[2] * X - names[3] * Y, names[1] + names[3] * X + names[2] * Y)
    values = zip(*[field.nodal_values(component) for component in fields])
    return column([lift(value, (field.l, *names)) for pair in values for value in pair])


e_0 = Symbol(r"\mathbf e_0", initial_nodes())


def fibre(gradient, direction):
    """Image of a direction under a gradient."""
    return [total(gradient[i, k] * direction[k] for k in PLANE) for i in PLANE]


def dot(a, b):
    """Scalar product."""
    return total(p * q for p, q in zip(a, b))


def strain_of_fibres():
    """Strain tensor from lengths alone: of fibres along x, along y and along both diagonals."""
    def length(*direction):
        image = fibre(J.meaning, direction)
        return normal(dot(image, image))

    shear = (length(1, 1) - length(1, -1)) * fmpq(1, 8)
    return Matrix([[(length(1, 0) - 1) * HALF, shear], [shear, (length(0, 1) - 1) * HALF]])


STRAIN = strain_of_fibres()
eps_m = Symbol(r"\boldsymbol\varepsilon_m", STRAIN)
VECTOR = ((0, 0), (1, 1), (0, 1))


def vector(tensor):
    """A symmetric tensor as (11, 22, 12)."""
    return column([tensor[place] for place in VECTOR])


eps_1, eps_2, eps_3 = (Symbol(rf"\varepsilon_{k + 1}", STRAIN[place]) for k, place in enumerate(VECTOR))
eps_f = Symbol(r"\boldsymbol\varepsilon_f", vector(STRAIN))


def heated():
    """Strain relative to the metric (1 + 2 alpha dT) I of the freely expanded body."""
    free = 1 + 2 * GEN["heat"]
    def against(i, j):
        C = dot([J.meaning[k, i] for k in PLANE], [J.meaning[k, j] for k in PLANE])
        return normal((C - (free if i == j else 0)) * HALF)
    return column([against(*place) for place in VECTOR])


eps = Symbol(r"\boldsymbol\varepsilon", heated())
EPS = [entry for (entry,) in eps.meaning.rows]
bar_1, bar_2, bar_3 = (Symbol(rf"\bar\varepsilon_{k + 1}", entry) for k, entry in enumerate(EPS))
eps_T = Symbol(r"\boldsymbol\varepsilon_T", column([GEN["heat"], GEN["heat"], ZERO]))


@cache
def columns_of_J():
    """J for each unit vector of nodal coordinates; J is linear in e."""
    return [J.meaning.each(lambda entry: entry.derivative(name)) for name in NODAL]


def polarised(a, b):
    """The matrix B with e^T B f = (J(e)^T J(f))_ab."""
    units = columns_of_J()
    return Matrix([[dot([P[k, a] for k in PLANE], [Q[k, b] for k in PLANE]) for Q in units] for P in units])


S_a, S_b, S_c = (Symbol(rf"\mathbf S_{name}", polarised(*place)) for name, place in zip("abc", VECTOR))
SQUARES = [hessian(entry * 2, NODAL) for entry in (STRAIN[place] for place in VECTOR)]
S_a1, S_b1, S_c1 = (Symbol(rf"\mathbf S_{{{name}1}}", H) for name, H in zip("abc", SQUARES))

# Stress and energy.


def hooke(strain):
    """The stress lambda tr(E) I + 2 mu E."""
    lam, mu = GEN["lam"], GEN["mu"]
    trace = strain[0, 0] + strain[1, 1]
    return Matrix([[2 * mu * strain[i, j] + (lam * trace if i == j else 0) for j in PLANE] for i in PLANE])


def tensor(vector):
    """(11, 22, 12) as a symmetric tensor."""
    return Matrix([[vector[0], vector[2]], [vector[2], vector[1]]])


sigma = Symbol(r"\boldsymbol\sigma", vector(hooke(tensor(EPS))))
SIGMA = [entry for (entry,) in sigma.meaning.rows]
sigma_1, sigma_2, sigma_3 = (Symbol(rf"\sigma_{k + 1}", entry) for k, entry in enumerate(SIGMA))


def own_strain():
    """Strain minus thermal strain in the rod's own axes, from r_x and r_y, without the inclination."""
    slopes = [[component.derivative(name) for component in r_components()] for name in ("x", "y")]
    return Matrix([[(dot(slopes[i], slopes[j]) - (ONE + 2 * GEN["heat"] if i == j else 0)) * HALF for j in PLANE]
                   for i in PLANE])


def r_components():
    """The components of r."""
    return [entry for (entry,) in r.meaning.rows]


@cache
def energy():
    """U as the integral of C_ijkl E_ij E_kl / 2 in the rod's own axes."""
    E = own_strain()
    stress = hooke(E)
    return normal(over_volume(total(E[i, j] * stress[i, j] for i in PLANE for j in PLANE) * HALF))
