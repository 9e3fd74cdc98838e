"""A cantilever under the moment 2 pi E I/L at its end: a circle, and its change under the Green-Lagrange strain.

(a) Inextensible, M = E I phi': phi' = 2 pi/L, and the tip returns to the clamp.

(b) The paper's field r + y d, nu = 0, thickness free. Uniform bending: |r'| = a, |d| = c, rotation by k per unit of
initial length. The deformation gradient is R diag(a - y c k, c) with a rotation R. The energy of a unit length is

    W(a, c, k) = E w/2 int (E_11^2 + E_22^2) dy,   E_11 = ((a - y c k)^2 - 1)/2,   E_22 = (c^2 - 1)/2.

Without axial force and force through the thickness, dW/da = dW/dc = 0; the moment is dW/dk. With z = (h k)^2

    c^2 = (1 - z/6)/(1 - z^2/20),   a^2 = 1 - z c^2/4,   M = E I k c^2 (1 - 3 z c^2/10),

which `law` proves. The rod softens as it bends: its axis shortens, and it rotates by k L > 2 pi.
"""

import sympy
from mpmath import mp, mpf

from . import value

SOURCE = "(a) Euler 1744; (b) derived here from the strain energy"

HEIGHTS = (0.05, 0.02, 0.01)
UNITS = {"stretch": "1", "thickness": "1", "turned": "rad", "tip.x": "m", "tip.y": "m"}
METHODS = ("closed form with one root", "stationarity of the energy by quadrature")


def law():
    """c^2, a^2 and M/(E I) as functions of k and h; they must make W stationary."""
    a, c, k, h, y = sympy.symbols("a c k h y", positive=True)
    E_11, E_22 = ((a - y * c * k) ** 2 - 1) / 2, (c**2 - 1) / 2
    W = sympy.integrate(sympy.expand(E_11**2 + E_22**2), (y, -h / 2, h / 2)) / 2
    z = (h * k) ** 2
    C = (1 - z / 6) / (1 - z**2 / 20)
    A = 1 - z * C / 4
    M = k * C * (1 - 3 * z * C / 10)
    equilibrium = {c: sympy.sqrt(C), a: sympy.sqrt(A)}
    for condition in (W.diff(a), W.diff(c), W.diff(k) - h**3 / 12 * M):
        assert sympy.simplify(condition.subs(equilibrium)) == 0, condition
    return tuple(sympy.lambdify((k, h), result, "mpmath") for result in (C, A, M))


def tip(a, c, k, L):
    """Values for a rod of length L that rotates by k per unit of length."""
    return {"stretch": a, "thickness": c, "turned": k * L, "tip.x": a / k * mp.sin(k * L),
            "tip.y": a / k * (1 - mp.cos(k * L))}


def by_closed_form(h, L, closed):
    """Values from the law: root k of M(k)/(E I) = 2 pi/L on the branch of the unloaded rod."""
    C, A, M = closed
    full = 2 * mp.pi / L
    k = mp.findroot(lambda k: M(k, h) - full, full * (1 + (h * full) ** 2 / 2))
    return tip(mp.sqrt(A(k, h)), mp.sqrt(C(k, h)), k, L)


def by_energy(h, L):
    """Values from dW = M dk alone, with the integral over the thickness by Gauss's rule (exact for degree 4)."""
    x = mp.sqrt(mpf(3) / 5)
    rule = [(-x * h / 2, 5 * h / 18), (mpf(0), 8 * h / 18), (x * h / 2, 5 * h / 18)]
    I = h**3 / 12

    def out_of_balance(a, c, k):
        sums = [mpf(0)] * 3
        for y, weight in rule:
            along = a - y * c * k
            stress, across = along * (along**2 - 1) / 2, c * (c**2 - 1) / 2
            for n, rate in enumerate((stress, across - stress * y * k, -stress * y * c)):
                sums[n] += weight * rate
        return [sums[0] / h, sums[1] / h, (sums[2] - I * 2 * mp.pi / L) / I]

    return tip(*mp.findroot(out_of_balance, (mpf(1), mpf(1), 2 * mp.pi / L)), L)


def entries():
    """Entries: the elastica, and the Green-Lagrange rod with three heights."""
    closed = law()
    with mp.workdps(value.WORKING):
        L = mpf(1)
        full = {"stretch": mpf(1), "turned": 2 * mp.pi, "tip.x": mpf(0), "tip.y": mpf(0)}
        yield {
            "id": "circle-elastica",
            "tags": ["statics", "circle", "inextensible", "shear-rigid"],
            "problem": "the rod under the end moment 2 pi E I/L",
            "source": SOURCE,
            "parameters": {"L": 1.0, "ML/EI": "2 pi"},
            "values": {name: value.analytic(UNITS[name], number) for name, number in full.items()},
        }
        for h in HEIGHTS:
            height = value.exact(h)
            yield {
                "id": f"circle-green-lagrange-{h}",
                "tags": ["statics", "circle", "green-lagrange", "element"],
                "problem": "the rod of the paper's field and strain energy, nu = 0, under the end moment 2 pi E I/L",
                "source": SOURCE,
                "parameters": {"L": 1.0, "h": h, "nu": 0.0, "ML/EI": "2 pi"},
                "values": value.agreed(METHODS, UNITS, by_closed_form(height, L, closed), by_energy(height, L)),
            }
