"""`fixtures/equations.json`: value of every equation in every state, exact and as f64."""

import platform
from importlib.metadata import version

import mpmath

from ..fixtures import fixture
from ..fixtures.tolerance import CONVENTIONS as TOLERANCE
from . import sanity, tags, tolerance
from .element import Element
from .quantities import QUANTITIES, AtPoint
from .states import states

FILE = "equations.json"

CONVENTIONS = {
    "units": "SI. Where nodal coordinates mix positions and slopes, the unit for positions, then for slopes.",
    "e": "layout (4): r_i, r_y_i, r_j, r_x_j, r_y_j, r_k, r_y_k, two global components each; "
         "i at x = 0, j at l/2, k at l.",
    "axes": "strains, stresses and S_a, S_b, S_c in global axes, as in (9)-(13), but axis.epsilon in the rod's own. "
            "e0 is the straight initial element, theta its inclination, in (-pi, pi].",
    "element": "0 <= x <= l, -h/2 <= y <= h/2, width w; points are [x, y].",
    "arrays": "matrices by rows; a quantity per point is a list with an entry for each point of the state.",
    "exact": "rational numbers as text, from exact inputs; cos_theta and sin_theta stand for theta.",
    "f64": "each the f64 nearest to the exact rational; theta the f64 nearest to the exact angle.",
    "model": "thermal strain: alpha dT I for 2d; alpha dT t t^T, t = (cos_theta, sin_theta), for 1d; "
             "zero for none.",
    "consistent": "derived from the energy density C_ijkl E_ij E_kl / 2 with "
                  "C_ijkl = lambda d_ij d_kl + mu (d_ik d_jl + d_il d_jk).",
    "axis": "beyond the paper: axis.epsilon = (11, 22, 2 12) in the rod's own axes, x along e0 and y across it; "
            "axis.U = 1/2 int epsilon^T D_0 epsilon dV + 1/2 h w int epsilon^T (D - D_0) epsilon dx at y = 0, "
            "with D_0 = diag(E*, E*, mu), E* = E/(1 - nu^2), "
            "D = [[lambda + 2 mu, lambda, 0], [lambda, lambda + 2 mu, 0], [0, 0, mu]]. At nu = 0 it and its "
            "derivatives are those of 18.U; where the gradient is uniform over the element, axis.U and axis.Q_e are.",
    "uniaxial": "beyond the paper: uniaxial.U = 1/2 int epsilon^T D epsilon dV with axis.epsilon and "
                "D = diag(E, E, G), G = E/(2 (1 + nu)): no Poisson contraction. At nu = 0 it is 18.U.",
    "printed": "as the paper prints it where it is wrong: E1 in A.3, E2 in 21.K_3, E3 in printed-shear, "
               "whose energy counts the shear strain once (2 mu for 4 mu); its K uses the consistent K_3.",
    "tags": "each is explained under `tags`; what a state is there for comes first.",
    "provenance": "every value is exact: derived in rational arithmetic from the field, the energy and the temperature.",
    **TOLERANCE,
    "edits": "none by hand: the generator's command writes this file, and with --check compares it.",
}

# Equations that restate others, with the quantities that hold their values.
ALIASES = {"A.5": ["2.S", "3.S", "4.nodes"]}


def generate():
    """The fixture."""
    sanity.demand_breadth(states())
    found = [entry(state) for state in states()]
    return {
        "schema": "ancf-equations/1",
        "title": "Values of equations (1)-(22) and (A.1)-(A.5) for single elements",
        "source": "Peng, Wang, Li, Zhi, Li 2018, doi 10.1155/2018/1752815",
        "generator": {
            "command": "python -m oracle equations",
            "python": ".".join(platform.python_version_tuple()[:2]),
            "sympy": version("sympy"),
            "python-flint": version("python-flint"),
        },
        "conventions": CONVENTIONS,
        "quantities": {id: description(id, quantity) for id, quantity in QUANTITIES.items()},
        "aliases": ALIASES,
        "tags": tags.of_all(found),
        "states": found,
    }


def description(id, quantity):
    """A quantity as the fixture describes it; its id starts with the number of its equation."""
    name = id.split("/")[0]
    return {
        "equation": name[:name.rindex(".")],
        "what": quantity.what,
        "shape": list(quantity.shape),
        "unit": quantity.unit,
        "per": quantity.per,
        "form": quantity.form,
        "terms": tolerance.TERMS[id].what,
    }


def entry(state):
    """One state with the values of all quantities."""
    element = Element(state)
    points = [AtPoint(element, place) for place in state.points]
    values = {
        id: quantity.value(element) if quantity.per == "element" else [quantity.value(at) for at in points]
        for id, quantity in QUANTITIES.items()
    }
    sanity.demand(state, values)
    allowed = tolerance.tolerances(state, values, element.mass.inv().tolist())
    seen = {"shear": [strain[2] for strain in values["axis.epsilon"]],
            "stretches": [J[0][0] * J[1][1] - J[0][1] * J[1][0] for J in values["9.J"]]}
    cosine, sine = map(fixture.rational, state.direction)
    return {
        "id": state.id,
        "tags": tags.all_of(state, **seen),
        "what": state.what,
        "state": inputs(state, fixture.nearest, {"theta": nearest_angle(*state.direction)}),
        "exact": inputs(state, fixture.rational, {"cos_theta": cosine, "sin_theta": sine}),
        "values": {
            id: {
                "exact": fixture.each(fixture.rational, value),
                "f64": fixture.each(fixture.nearest, value),
                **allowed[id],
            }
            for id, value in values.items()
        },
    }


def inputs(state, convert, angle):
    """Inputs of a program, as f64 or as exact text."""

    def numbers(*names):
        return {name: fixture.each(convert, getattr(state, name)) for name in names}

    return (
        numbers("l", "h", "w") | angle | numbers("e0", "e", "edot", "E", "nu", "rho", "alpha", "dT")
        | {"model": state.model} | numbers("points", "gravity")
    )


def nearest_angle(cosine, sine):
    """The f64 nearest to the angle, computed with fifty digits."""
    with mpmath.workdps(50):
        ratio = [mpmath.mpf(int(v.p)) / int(v.q) for v in (sine, cosine)]
        return float(mpmath.nstr(mpmath.atan2(*ratio), 50))


def differences(stored, fresh):
    """Differences, except in the versions of the tools."""
    tools = {"python", "sympy", "python-flint"}
    kept = {tool: version for tool, version in stored.get("generator", {}).items() if tool in tools}
    return fixture.differences(stored, fresh | {"generator": fresh["generator"] | kept})
