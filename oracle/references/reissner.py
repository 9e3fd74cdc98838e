"""The cantilever under a dead load F at its tip, geometrically exact with stretch and shear (Reissner 1972).

With the section's angle phi, its axes t and n and r' = (1 + eps) t + gamma n, the law is linear in these strains:

    N = E A eps,   Q = k G A gamma,   M = E I phi'.

Equilibrium gives N t + Q n = (0, -F), so eps = -F sin phi/(E A), gamma = -F cos phi/(k G A), and M' = F x':

    E I phi'' = F cos phi (1 + F beta sin phi),   beta = 1/(k G A) - 1/(E A),   phi(0) = 0, phi'(L) = 0.

With psi = -phi, psi_0 at the tip, a first integral is

    E I psi'^2/2 = F (sin psi_0 - sin psi) (1 - F beta/2 (sin psi_0 + sin psi)),

so that L and y are quadratures over psi; E I psi'(0) = F x is the moment at the clamp. The substitution
psi = psi_0 - s^2 removes the singularity of the root.

An element with the Green-Lagrange strain, like the paper's, has another law and another limit; the two differ by terms
of the order of the strains. `tests/references` measures the difference.
"""

from mpmath import mp, mpf

from . import collocation, value
from .elastica import ramp

QUOTED = "the text was not at hand, so take them as parameters, and none of its results is used"
SOURCE = {
    "stubby": "law: Reissner 1972. Load and sizes: the cantilever h = 0.5 m of Gerstmayr, Matikainen and "
    f"Mikkola 2008 and of Nachbagauer, Pechstein, Irschik and Gerstmayr 2011, F = 5e8 h^3; {QUOTED}",
    "slender": "law: Reissner 1972. Load and sizes: the cantilever F = 3 E I/L^2 of Gerstmayr and Irschik 2008; "
    f"{QUOTED}",
}

SIZES = {
    "stubby": {"L": 2.0, "h": 0.5, "w": 0.1, "E": 2.07e11, "F": 62.5e6},
    "slender": {"L": 2.0, "h": 0.1, "w": 0.1, "E": 2.07e11, "F": 1293750.0},
}

# Name, nu, shear correction factor k as a ratio; None: rigid in shear.
VARIANTS = (("nu0-k1", 0.0, "1"), ("nu0-k5_6", 0.0, "5/6"), ("nu0.3-k1", 0.3, "1"), ("nu0.3-k5_6", 0.3, "5/6"),
            ("shear-rigid", 0.0, None))

UNITS = {"tip.x": "m", "tip.y": "m", "tip.angle": "rad"}
METHODS = ("quadrature of the first integral", "Chebyshev collocation")


class Cantilever:
    """The cantilever by L, E I, F, the strains F/(E A) and F/(k G A), and F beta."""

    def __init__(self, sizes, nu, k):
        L, h, w, E, F = (value.exact(sizes[name]) for name in ("L", "h", "w", "E", "F"))
        self.L, self.F, self.EI = L, F, E * w * h**3 / 12
        self.stretch = F / (E * w * h)
        self.shear = 2 * (1 + value.exact(nu)) * self.stretch / ratio(k) if k else mpf(0)
        self.F_beta = self.shear - self.stretch

    def slopes(self, phi):
        """Derivatives x', y' of the axis."""
        sin, cos = mp.sin(phi), mp.cos(phi)
        along, across = 1 - self.stretch * sin, -self.shear * cos
        return along * cos - across * sin, along * sin + across * cos

    def by_quadrature(self):
        """Tip from the first integral."""

        def over_psi(f, psi_0):
            """Integral of f over the length."""

            def integrand(s):
                psi = psi_0 - s * s
                sinc = mp.sin(s * s / 2) / (s * s / 2) if s else mpf(1)
                drop = mp.cos(psi_0 - s * s / 2) * sinc  # (sin psi_0 - sin psi)/s^2
                rate = 2 * self.F / self.EI * drop * (1 - self.F_beta / 2 * (mp.sin(psi_0) + mp.sin(psi)))
                return 2 * f(psi) / mp.sqrt(rate)

            return mp.quad(integrand, [0, mp.sqrt(psi_0)], method="gauss-legendre")

        def too_long(psi_0):
            return over_psi(lambda psi: 1, psi_0) - self.L

        psi_0 = mp.findroot(too_long, (mpf("0.3"), mpf("1.2")), solver="anderson")
        sin = mp.sin(psi_0)
        x = self.EI / self.F * mp.sqrt(2 * self.F / self.EI * sin * (1 - self.F_beta / 2 * sin))
        return {"tip.x": x, "tip.y": over_psi(lambda psi: self.slopes(-psi)[1], psi_0), "tip.angle": -psi_0}

    def by_collocation(self):
        """Tip from phi'' = p cos phi (1 + F beta sin phi) over a unit length."""
        def f(phi, p):
            return p * mp.cos(phi) * (1 + self.F_beta * mp.sin(phi))

        def df(phi, p):
            return p * (self.F_beta * mp.cos(2 * phi) - mp.sin(phi))

        phi = collocation.solve(f, df, ramp(self.F * self.L**2 / self.EI))
        x, y = (self.L * collocation.integral(part) for part in zip(*map(self.slopes, phi)))
        return {"tip.x": x, "tip.y": y, "tip.angle": phi[-1]}


def ratio(text):
    """A ratio of whole numbers."""
    numerator, _, denominator = text.partition("/")
    return mpf(numerator) / int(denominator or 1)


def entries():
    """Entries: two beams, each with several shear laws."""
    with mp.workdps(value.WORKING):
        for beam, sizes in SIZES.items():
            for variant, nu, k in VARIANTS:
                rod = Cantilever(sizes, nu, k)
                yield {
                    "id": f"reissner-{beam}-{variant}",
                    "tags": ["statics", "reissner", "cantilever", beam, *(["shear-rigid"] if k is None else [])],
                    "problem": "tip of the geometrically exact cantilever, its section's angle with it, under a dead "
                    "load at its tip",
                    "source": SOURCE[beam],
                    "parameters": sizes | {"nu": nu, "k": k},
                    "values": value.agreed(METHODS, UNITS, rod.by_quadrature(), rod.by_collocation()),
                }
