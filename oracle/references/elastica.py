"""The inextensible, shear-rigid cantilever under a dead load P at its tip.

With the slope psi downwards, psi_0 at the tip: E I psi'' = -P cos psi, psi(0) = 0, psi'(L) = 0, so that
E I psi'^2 / 2 = P (sin psi_0 - sin psi). With m = (1 + sin psi_0)/2 and sin^2 phi_1 = 1/(2 m),

    sqrt(P L^2/(E I)) = K(m) - F(phi_1 | m),      -y = L - 2 (E(m) - E(phi_1 | m)) / sqrt(P/(E I)),
    x = sqrt(2 sin psi_0 E I/P).
"""

from mpmath import mp, mpf

from . import collocation, value

SOURCE = "Bisshopp and Drucker 1945 (elliptic integrals); Mattiasson 1981 (tables to five digits, met)"

# P L^2/(E I) -> Mattiasson's 1 - x/L, -y/L and psi_0.
TABLES = {1: (0.05643, 0.30172, 0.46135), 2: (0.16064, 0.49346, 0.78175), 5: (0.38763, 0.71379, 1.21537),
          10: (0.55500, 0.81061, 1.43029)}

UNITS = {"tip.x": "m", "tip.y": "m", "tip.angle": "rad"}


def by_elliptic_integrals(load):
    """Tip of the rod of length 1 from elliptic integrals."""

    def moduli(psi_0):
        m = (1 + mp.sin(psi_0)) / 2
        return m, mp.asin(mp.sqrt(1 / (2 * m)))

    def length(psi_0):
        m, phi_1 = moduli(psi_0)
        return mp.ellipk(m) - mp.ellipf(phi_1, m) - mp.sqrt(load)

    psi_0 = mp.findroot(length, (mpf("0.01"), mp.pi / 2 - mpf("0.001")), solver="anderson")
    m, phi_1 = moduli(psi_0)
    y = 2 * (mp.ellipe(m) - mp.ellipe(phi_1, m)) / mp.sqrt(load) - 1
    return {"tip.x": mp.sqrt(2 * mp.sin(psi_0) / load), "tip.y": y, "tip.angle": -psi_0}


def by_collocation(load):
    """Tip of the rod of length 1 from phi'' = load cos phi, with phi = -psi the angle of the axis."""
    phi = collocation.solve(lambda phi, p: p * mp.cos(phi), lambda phi, p: -p * mp.sin(phi), ramp(load))
    x, y = (collocation.integral([f(angle) for angle in phi]) for f in (mp.cos, mp.sin))
    return {"tip.x": x, "tip.y": y, "tip.angle": phi[-1]}


def ramp(load):
    """Load steps up to this load, small enough for Newton's iteration."""
    steps = int(mp.ceil(load / 2))
    return [mpf(load) * (k + 1) / steps for k in range(steps)]


def entries():
    """One entry per load."""
    with mp.workdps(value.WORKING):
        for load, table in TABLES.items():
            first = by_elliptic_integrals(mpf(load))
            printed = (1 - first["tip.x"], -first["tip.y"], -first["tip.angle"])
            assert all(abs(a - b) <= 6e-6 for a, b in zip(printed, table)), f"{load}: {printed}, not {table}"
            methods = ("elliptic integrals", "Chebyshev collocation")
            yield {
                "id": f"elastica-{load}",
                "tags": ["statics", "elastica", "cantilever", "inextensible", "shear-rigid"],
                "problem": "tip of the inextensible, shear-rigid cantilever under a dead load at its tip",
                "source": SOURCE,
                "parameters": {"L": 1.0, "PL^2/EI": float(load)},
                "values": value.agreed(methods, UNITS, first, by_collocation(mpf(load))),
            }
