"""`fixtures/structure.json`: rods pinned to one another; terms of (23), motions, rigid limit."""

import platform
from importlib.metadata import version

from ..fixtures import fixture, tolerance
from . import cases, mechanism, trajectories

FILE = "structure.json"
TOOLS = ("numpy", "scipy", "sympy", "python-flint", "mpmath")

CONVENTIONS = {
    "units": "SI: m, s, kg, N, J, K.",
    "scene": "a scene file; its numbers are the decimals as written.",
    "q": "rod by rod in the scene's order; along each rod the nodal vectors r, r_y, then r_j, r_x_j, r_y_j, "
         "r_k, r_y_k for each element, as in (4); neighbours in a rod share r and r_y at their node; each "
         "vector x before y. 14 coordinates for one element, 24 for two.",
    "axes": "vectors in global axes; r_x and r_y are the derivatives by the element's own x and y. At first "
            "r_x is t, the direction from `from` to `to`, and r_y is t turned by +90 degrees.",
    "points": "`from` is the rod's first r, `to` its last; a pivot is r_j of the middle element for an odd "
              "number of elements, the r between the two middle elements for an even number.",
    "rows": "rows of Phi. First the pins: points in alphabetical order, at each point the rods that meet "
            "there in the scene's order, consecutive pairs, Phi = r(second rod) - r(first rod), x before y. "
            "Then the supports in the scene's order, for each: fix, a row for each letter as written, "
            "r - r_0; slide: n . (r - r_0) with n = (-c_y, c_x)/|c|; clamp: t_0 . r_y, where t_0 is the "
            "rod's direction at first and r_y is at the clamped point. r_0 is the point's place in the "
            "scene. `rows` says each in words.",
    "first rod": "fix, slide and point forces act on the first of the rods, in the scene's order, that have "
                 "the point.",
    "sign": "m q'' + Q_e + Phi_q^T lambda = f. A support's force on the structure is minus its part of "
            "Phi_q^T lambda.",
    "heat": "dT of each rod from its own history, else from the scene's: linear between the entries, "
            "constant outside. A force's history is its factor in the same way.",
    "consistent": "Q_e is the derivative of the strain energy of `equations.json`, f of the work of weight "
                  "and forces, Phi_q of Phi.",
    "printed": "E4: with Phi_q lambda for Phi_q^T lambda, which is defined only where there are as many "
               "constraints as coordinates.",
    "states": "q, q'' and lambda are arbitrary: they need not satisfy Phi = 0 or (23), whose residual is "
              "given. `exact` is rational text, `state` and f64 are the f64 nearest to it. 23.acceleration "
              "and 23.lambda solve (23) with Phi_q q'' = 0 at the case's q and t.",
    "square": "no scene but one element, in the shape of a state of `equations.json`, and Phi_q as data; "
              "Phi = Phi_q (q - e0).",
    "trajectories": "from rest at the initial structure. position and velocity by point; reactions: force of "
                    "the supports on the structure, by point; moments: moment of a clamp on the structure, "
                    "counter-clockwise, by point; pins: by point and rod, the force on that rod by the pin. "
                    "Each has an entry for each t. nodal.q and initial_acceleration: q of `q` at the times nodal.t, and "
                    "its q'' at t = 0.",
    "energy": "kinetic; strain, as the integral of C_ijkl (E - E_T)_ij (E - E_T)_kl / 2; potential of the "
              "weight, zero at y = 0; input, the work of point forces and of heating since t = 0. "
              "energy_drift is the largest error of the balance; a kept one is no evidence of accuracy.",
    "error_estimate": "largest difference between two integrators over samples, points and components: "
                      "position m, velocity m/s, force N (moments N m), energy J without the input, nodal m and 1.",
    "rigid": "n scissors of rigid rods: a_k = ((k-1) L cos theta, L sin theta), "
             "b_k = ((k-1) L cos theta, 0), rods a_k - b_(k+1) and b_k - a_(k+1) pinned at their middles and "
             "at coinciding ends; b_1 held, a_1 slides on x = 0, F acts on a_1 in -y, no gravity; from rest "
             "at theta_0 (degrees). tip is a_(n+1), theta in rad, flat_at the time of theta = 0; samples end "
             "before it.",
    **tolerance.CONVENTIONS,
    "edits": "never by hand: the command under generator writes this file, and with --check compares it.",
}


def generate():
    """The fixture."""
    states = cases.cases()
    return {
        "schema": "ancf-structure/1",
        "title": "Rods pinned to one another: the terms of equation (23), motions, and the rigid mechanism",
        "source": "Peng, Wang, Li, Zhi, Li 2018, doi 10.1155/2018/1752815",
        "generator": {
            "command": "python -m oracle structure",
            "python": ".".join(platform.python_version_tuple()[:2]),
            **{tool: version(tool) for tool in TOOLS},
        },
        "conventions": CONVENTIONS,
        "quantities": cases.descriptions(),
        "tags": cases.TAGS,
        "states": states,
        "cases": states,
        "trajectories": trajectories.generate(),
        "rigid": mechanism.generate(),
    }


def keep(stored, fresh):
    """The fresh document with the stored digits wherever rounding explains the difference: no value changes unless it must."""
    return trajectories.settled_runs(fresh, stored)


def differences(stored, fresh):
    """Differences, except in the versions of the tools and in digits of integrated numbers that rounding explains."""
    tools = {"python", *TOOLS}
    kept = {tool: version for tool, version in stored.get("generator", {}).items() if tool in tools}
    fresh = fresh | {"generator": fresh["generator"] | kept}
    return fixture.differences(trajectories.settled_runs(stored, fresh), fresh)
