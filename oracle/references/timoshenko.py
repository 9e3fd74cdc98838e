"""Tip of a cantilever under the load P by Timoshenko's linear theory.

    E I phi'' = P, phi(0) = 0, phi'(L) = 0;   k G A (v' - phi) = -P, v(0) = 0
    ->   -v(L) = P L^3/(3 E I) + P L/(k G A),   -phi(L) = P L^2/(2 E I).

In plane strain E/(1 - nu^2) replaces E if the section can thicken on one side of the axis and thin on the other. In a
field linear in y it cannot: E_22 = 0 and lambda + 2 mu replaces E. The deflection of a slender rod is then
(1 - 2 nu)/(1 - nu)^2 of the right one.
"""

import sympy
from mpmath import mp

from . import value

SOURCE = "Timoshenko 1921; any textbook"

# For each L/h: h, and the load P = 3e-8 E I/L^2, whose bending deflection is 1e-8 L.
CASES = {2: (0.5, 1.25e-3), 10: (0.1, 1e-5), 100: (0.01, 1e-8), 1000: (0.001, 1e-11)}
SIZES = {"L": 1.0, "w": 0.02, "E": 2e8, "k": "1"}

# Name, L/h, nu.
VARIANTS = (*((f"{slenderness}", slenderness, 0.0) for slenderness in CASES),
            ("plane-strain", 100, 0.3), ("plane-strain-locked", 100, 0.3))
PROBLEM = {"plane-strain": ", plane strain",
           "plane-strain-locked": ", plane strain with E_22 = 0"}


def tip():
    """Deflection and angle as functions of P, L, E I and k G A, from the two equations."""
    P, L, EI, kGA, x = sympy.symbols("P L EI kGA x", positive=True)
    moment = -P * (L - x)
    phi = sympy.integrate(moment / EI, (x, 0, x))
    deflection = sympy.integrate(phi - P / kGA, (x, 0, L))
    angle = phi.subs(x, L)
    assert sympy.expand(deflection + P * L**3 / (3 * EI) + P * L / kGA) == 0
    assert sympy.expand(angle + P * L**2 / (2 * EI)) == 0
    # Castigliano's theorem: the deflection is dU/dP of the stored energy.
    U = sympy.integrate(moment**2 / (2 * EI) + P**2 / (2 * kGA), (x, 0, L))
    assert sympy.expand(U.diff(P) + deflection) == 0
    return sympy.lambdify((P, L, EI, kGA), (deflection, angle), "mpmath")


def entries():
    """Entries for each slenderness at nu = 0, and for plane strain."""
    solution = tip()
    with mp.workdps(value.WORKING):
        for name, slenderness, poisson in VARIANTS:
            h, P = CASES[slenderness]
            L, w, E, height, load, nu = map(value.exact, (SIZES["L"], SIZES["w"], SIZES["E"], h, P, poisson))
            mu = E / 2 / (1 + nu)
            modulus = {"plane-strain": E / (1 - nu**2), "plane-strain-locked": 2 * mu * (1 - nu) / (1 - 2 * nu)}
            deflection, angle = solution(load, L, modulus.get(name, E) * w * height**3 / 12, mu * w * height)
            yield {
                "id": f"timoshenko-{name}",
                "tags": ["statics", "timoshenko", "cantilever", "linear", "beam" if nu == 0 else name],
                "problem": f"tip of the cantilever under a small load{PROBLEM.get(name, '')}",
                "source": SOURCE,
                "parameters": SIZES | {"h": h, "nu": poisson, "P": P},
                "values": {
                    "tip.y": value.analytic("m", deflection),
                    "tip.angle": value.analytic("rad", angle),
                },
            }
