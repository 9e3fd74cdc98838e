"""`fixtures/cable.json`: values of the gradient-deficient cable element in every state."""

import platform
from importlib.metadata import version

from ..element import equations, tags
from ..element.quantities import NODAL_FORCE, NODAL_STIFFNESS, Quantity, point
from ..fixtures import fixture
from ..fixtures.tolerance import CONVENTIONS as TOLERANCE
from . import ball, sanity, tolerance
from .element import DOF, EPSILON, KAPPA, Element
from .states import states

FILE = "cable.json"

CONVENTIONS = {
    "units": "SI. Where nodal coordinates mix positions and slopes, the unit for positions, then for slopes.",
    "e": "r_i, r_x_i, r_k, r_x_k, two global components each; i at x = 0, k at l; r_x is dr/dx. e0 is the straight "
         "initial element, theta its inclination, in (-pi, pi].",
    "element": "an axis 0 <= x <= l with the section h (in the plane) times w; points are [x, 0]. r is the cubic in "
               "x through the nodal values (Berzeri and Shabana 2000).",
    "strains": "of the axis, after Gerstmayr and Irschik 2008: epsilon = |r_x| - 1 - alpha dT and the material "
               "curvature kappa = (r_x cross r_xx)/|r_x|^2. The models 1d and 2d are the same; none has no heat.",
    "energy": "U is a sum of Gauss points over the length, which belongs to the definition: five points of "
              "E A epsilon^2/2 and three of E I kappa^2/2, A = h w, I = w h^3/12. nu is not used.",
    "inertia": "of the axis, rho A for each length, integrated exactly; none of the section's rotation.",
    "arrays": "matrices by rows; a quantity per point is a list with an entry for each point of the state.",
    "exact": "rational numbers as text, from exact inputs; cos_theta and sin_theta stand for theta.",
    "decimal": f"in place of exact where roots enter: {ball.DIGITS} significant digits as text, at most one unit of "
               "the last off, by ball arithmetic.",
    "f64": "each the f64 nearest to the exact number; theta the f64 nearest to the exact angle.",
    "tags": "each is explained under `tags`; what a state is there for comes first.",
    "provenance": "every value is exact where it is rational, and otherwise enclosed by ball arithmetic.",
    **TOLERANCE,
    "edits": "none by hand: the generator's command writes this file, and with --check compares it.",
}

SQUARE = (DOF, DOF)


def along(values):
    """A function that evaluates polynomials in x at a point."""
    return lambda at: [polynomial(at.x) for polynomial in values(at.element)]


class AtPoint:
    """An element at one place of its axis."""

    def __init__(self, element, point):
        self.element, self.x = element, point[0]


QUANTITIES = {
    "cable.S": point("shape functions S_1 ... S_4", (4,), "1; slopes m", along(lambda el: el.shapes)),
    "cable.S_x": point("their derivatives in x", (4,), "1/m; slopes 1", along(lambda el: el.shapes_x)),
    "cable.S_xx": point("their second derivatives in x", (4,), "1/m^2; slopes 1/m", along(lambda el: el.shapes_xx)),
    "cable.r": point("position", (2,), "m", along(lambda el: el.field(el.shapes, el.state.e))),
    "cable.r_x": point("slope, derivative of r in x", (2,), "1", along(lambda el: el.slope)),
    "cable.r_xx": point("second derivative of r in x", (2,), "1/m", along(lambda el: el.bend)),
    "cable.epsilon": point("axial strain |r_x| - 1 - alpha dT", (), "1", lambda at: at.element.strain(EPSILON, at.x)),
    "cable.kappa": point("curvature (r_x cross r_xx)/|r_x|^2", (), "1/m", lambda at: at.element.strain(KAPPA, at.x)),
    "cable.T": Quantity("kinetic energy", (), "J", lambda el: el.kinetic_energy),
    "cable.M": Quantity("mass matrix", SQUARE, "kg; slopes kg m, kg m^2", lambda el: el.mass.tolist()),
    "cable.U": Quantity("strain energy", (), "J", lambda el: el.energy),
    "cable.Q_e": Quantity("elastic force dU/de", (DOF,), NODAL_FORCE, lambda el: el.force),
    "cable.tangent": Quantity("second derivative of U", SQUARE, NODAL_STIFFNESS, lambda el: el.tangent),
    "cable.Q_w": Quantity("derivative of the weight's work", (DOF,), NODAL_FORCE, lambda el: el.gravity_force),
    "cable.eddot": Quantity("accelerations solving M eddot = Q_w - Q_e", (DOF,), "m/s^2; slopes 1/s^2",
                            lambda el: el.acceleration),
}


def generate():
    """The fixture."""
    elements = [Element(state) for state in states()]
    found = [values_of(element) for element in elements]
    sanity.demand_of_all(states(), found)
    entries = [entry(*pair) for pair in zip(elements, found)]
    return {
        "schema": "ancf-cable/1",
        "title": "Values of the gradient-deficient cable element for single elements",
        "source": "Berzeri and Shabana 2000 (interpolation); Gerstmayr and Irschik 2008 (strains)",
        "generator": {
            "command": "python -m oracle cable",
            "python": ".".join(platform.python_version_tuple()[:2]),
            "sympy": version("sympy"),
            "python-flint": version("python-flint"),
        },
        "conventions": CONVENTIONS,
        "quantities": {
            id: {"what": quantity.what, "shape": list(quantity.shape), "unit": quantity.unit, "per": quantity.per,
                 "terms": tolerance.TERMS[id]}
            for id, quantity in QUANTITIES.items()
        },
        "tags": tags.of_all(entries),
        "states": entries,
    }


def values_of(element):
    """All values of one state, once their identities are asserted."""
    points = [AtPoint(element, place) for place in element.state.points]
    values = {
        id: quantity.value(element) if quantity.per == "element" else [quantity.value(at) for at in points]
        for id, quantity in QUANTITIES.items()
    }
    sanity.demand(element.state, {id.removeprefix("cable."): value for id, value in values.items()})
    return values


def entry(element, values):
    """One state as it is stored."""
    state = element.state
    allowed = tolerance.tolerances(state, values, element.mass.inv().tolist())
    cosine, sine = map(fixture.rational, state.direction)
    angle = equations.nearest_angle(*state.direction)
    return {
        "id": state.id,
        "tags": tags.all_of(state),
        "what": state.what,
        "state": equations.inputs(state, fixture.nearest, {"theta": angle}),
        "exact": equations.inputs(state, fixture.rational, {"cos_theta": cosine, "sin_theta": sine}),
        "values": {id: stored(value) | allowed[id] for id, value in values.items()},
    }


def stored(value):
    """Numbers as text and as f64: exact where all are rational, decimal otherwise."""
    text = ("exact", fixture.rational) if ball.is_exact(value) else ("decimal", ball.decimal)
    return {text[0]: fixture.each(text[1], value), "f64": fixture.each(ball.nearest, value)}


differences = equations.differences
