"""A straight heated rod, free and between walls, with the paper's strain: Green-Lagrange minus alpha dT.

Stretched by a along and by c across, E_11 = (a^2 - 1)/2 - p alpha dT and E_22 = (c^2 - 1)/2 - s alpha dT, where (p, s) is
(1, 1) in the 2D model, (1, 0) in the 1D one and (0, 1) in the transverse one;
W = lambda/2 (E_11 + E_22)^2 + mu (E_11^2 + E_22^2). The section is free to thicken: dW/dc = 0.

    free:           a^2 = 1 + 2 p alpha dT, c^2 = 1 + 2 s alpha dT, no force
    between walls:  a = 1, c^2 = 1 + 2 alpha dT (s + p nu/(1 - nu)), N = A dW/da = -p E A alpha dT/(1 - nu^2)

N does not depend on s: heat across the rod only thickens it, at any nu.

Euler and Bernoulli's rod has the axial strain a - 1 - alpha dT and W = E A/2 (a - 1 - alpha dT)^2, with Young's modulus
because the section is free to contract across. Free a = 1 + alpha dT, between walls N = -E A alpha dT, for any nu and in
both models.
"""

import sympy
from mpmath import mp

from . import value

SOURCE = "derived here from the strain energy; Peng et al. 2018, (8), (14)-(18)"
AXIAL_SOURCE = "derived here from the strain energy; strain |r_x| - 1: Gerstmayr and Irschik 2008"

TABLE_1 = {"h": 0.02, "w": 0.02, "E": 2e8, "alpha": 2.85e-5}
FREE_DT, HELD_DT = 200.0, 5.0

# Whether heat strains the rod along and across.
DIRECTIONS = {"1d": (1, 0), "2d": (1, 1), "transverse": (0, 1)}


def law():
    """For each model, squared stretches and force per E A as functions of nu and alpha dT, solved and compared with the above."""
    nu, heat, a, c = sympy.symbols("nu heat a c", positive=True)
    mu = sympy.Rational(1, 2) / (1 + nu)  # of E = 1
    lame = 2 * mu * nu / (1 - 2 * nu)
    states = {}
    for model, (along, across) in DIRECTIONS.items():
        E_11, E_22 = (a**2 - 1) / 2 - along * heat, (c**2 - 1) / 2 - across * heat
        W = lame / 2 * (E_11 + E_22) ** 2 + mu * (E_11**2 + E_22**2)
        free = {a: sympy.sqrt(1 + 2 * along * heat), c: sympy.sqrt(1 + 2 * across * heat)}
        assert all(sympy.simplify(W.diff(s).subs(free)) == 0 for s in (a, c)), "no force in the free rod"
        held = W.subs(a, 1)
        (thickness,) = sympy.solve(sympy.expand(held.diff(c) / c), c**2)
        assert sympy.simplify(thickness - (1 + 2 * heat * (across + along * nu / (1 - nu)))) == 0
        force = sympy.simplify(W.diff(a).subs(a, 1).subs(c, sympy.sqrt(thickness)))
        assert sympy.simplify(force + along * heat / (1 - nu**2)) == 0
        results = (free[a] ** 2, free[c] ** 2, thickness, force)
        states[model] = sympy.lambdify((nu, heat), results, "mpmath")
    return states


def axial_law():
    """Euler and Bernoulli: stretch of the free rod and force per E A between walls, as functions of alpha dT."""
    heat, a = sympy.symbols("heat a", positive=True)
    force = ((a - 1 - heat) ** 2 / 2).diff(a)
    (free,) = sympy.solve(force, a)
    assert sympy.expand(free - 1 - heat) == 0 and sympy.expand(force.subs(a, 1) + heat) == 0
    return sympy.lambdify(heat, (free, force.subs(a, 1)), "mpmath")


def entries():
    """Entries: every model at nu = 0 and 0.3, and Euler and Bernoulli's rod."""
    states, axial = law(), axial_law()
    with mp.workdps(value.WORKING):
        EA = value.exact(TABLE_1["E"]) * value.exact(TABLE_1["h"]) * value.exact(TABLE_1["w"])
        alpha = value.exact(TABLE_1["alpha"])
        for model, state in states.items():
            for nu in (0.0, 0.3):
                along, across, _, _ = state(value.exact(nu), alpha * value.exact(FREE_DT))
                yield {
                    "id": f"thermal-free-{model}-nu{nu}",
                    "tags": ["statics", "thermal", "free", "element"],
                    "problem": "stretches of the heated rod that nothing holds",
                    "source": SOURCE,
                    "parameters": TABLE_1 | {"nu": nu, "dT": FREE_DT, "model": model},
                    "values": {
                        "stretch": value.analytic("1", mp.sqrt(along)),
                        "thickness": value.analytic("1", mp.sqrt(across)),
                    },
                }
                _, _, thickness, force = state(value.exact(nu), alpha * value.exact(HELD_DT))
                yield {
                    "id": f"thermal-clamped-{model}-nu{nu}",
                    "tags": ["statics", "thermal", "clamped", "element"],
                    "problem": "axial force of the heated rod between walls, straight, its section free to thicken",
                    "source": SOURCE,
                    "parameters": TABLE_1 | {"nu": nu, "dT": HELD_DT, "model": model},
                    "values": {
                        "N": value.analytic("N", EA * force),
                        "thickness": value.analytic("1", mp.sqrt(thickness)),
                    },
                }
        free, held = (alpha * value.exact(dT) for dT in (FREE_DT, HELD_DT))
        yield {
            "id": "thermal-free-euler-bernoulli",
            "tags": ["statics", "thermal", "free", "euler-bernoulli"],
            "problem": "stretch of Euler and Bernoulli's heated rod that nothing holds",
            "source": AXIAL_SOURCE,
            "parameters": TABLE_1 | {"nu": 0.3, "dT": FREE_DT},
            "values": {"stretch": value.analytic("1", axial(free)[0])},
        }
        yield {
            "id": "thermal-clamped-euler-bernoulli",
            "tags": ["statics", "thermal", "clamped", "euler-bernoulli"],
            "problem": "axial force of Euler and Bernoulli's heated rod between walls, straight",
            "source": AXIAL_SOURCE,
            "parameters": TABLE_1 | {"nu": 0.3, "dT": HELD_DT},
            "values": {"N": value.analytic("N", EA * axial(held)[1])},
        }
