"""Rods that are bowed without stress at the start, by the amplitude a.

A pinned column under the load P, bowed by v_0 = a sin(pi x/L), with sections normal to its axis, phi_0 = v_0'. With a small
deflection v and the angle phi of the sections its energy is

    1/2 int E I (phi' - phi_0')^2 + k G A (v' - phi)^2 - P (v'^2 - v_0'^2) dx.

The sine stays one, and its amplitude is a/(1 - P/P_cr), where 1/P_cr = L^2/(pi^2 E I) + 1/(k G A).

A rod between clamps, heated by alpha dT = eps and bowed by a sin^2(pi x/L). The bow grows to w, still that shape, which is the
mode of buckling. Its length changes by pi^2 (w^2 - a^2)/(4 L^2) of itself, so that it presses with N = E A (eps - that), and
the shape is in equilibrium for N = P_cr (1 - a/w). Without a shear strain P_cr = 4 pi^2 E I/L^2 = E A eps_cr:

    eps - pi^2 (w^2 - a^2)/(4 L^2) = eps_cr (1 - a/w),   eps_cr = pi^2 h^2/(3 L^2).
"""

import sympy
from mpmath import findroot, mp

from . import value

SOURCE = "derived here; Timoshenko and Gere, Theory of Elastic Stability, 1961, 1.12 (initial curvature) and 2.17 (shear)"

COLUMN = {"L": 1.0, "h": 0.01, "w": 0.02, "E": 2e8, "nu": 0.0, "k": "1", "a": 1e-6}
SHARES = (0.25, 0.5, 0.75, 0.9)
HEATED = {"L": 1.0, "h": 0.02, "w": 0.02, "E": 7e10, "nu": 0.0, "alpha": 2.3e-5}
TIMES_CRITICAL, AMPLITUDES = 3, (1e-4, 1e-3)


def column():
    """Amplitude over a as a function of P, E I pi^2/L^2 and k G A, from the energy of sines."""
    P, EI, GA, a, v, phi, x, L = sympy.symbols("P EI GA a v phi x L", positive=True)
    wave = sympy.pi / L
    axis, start = v * sympy.sin(wave * x), a * sympy.sin(wave * x)
    sections, at_start = phi * wave * sympy.cos(wave * x), a * wave * sympy.cos(wave * x)
    bending = EI * (sections - at_start).diff(x) ** 2
    shear = GA * ((axis.diff(x) - sections) - (start.diff(x) - at_start)) ** 2
    pressed = P * (axis.diff(x) ** 2 - start.diff(x) ** 2)
    energy = sympy.integrate(sympy.expand((bending + shear - pressed) / 2), (x, 0, L))
    (solution,) = sympy.solve([energy.diff(v), energy.diff(phi)], [v, phi], dict=True)
    critical = 1 / (1 / (EI * wave**2) + 1 / GA)
    assert sympy.simplify(solution[v] - a / (1 - P / critical)) == 0
    return sympy.lambdify((P, EI, GA, L, a), solution[v], "mpmath")


def heated():
    """Residual of the bow w from the energy of stretch and bending of a rod with the shape w sin^2."""
    w, a, eps, h, L, x = sympy.symbols("w a eps h L x", positive=True)
    shape = sympy.sin(sympy.pi * x / L) ** 2
    longer = sympy.integrate(sympy.expand(shape.diff(x) ** 2), (x, 0, L)) / (2 * L) * (w**2 - a**2)
    bending = sympy.integrate(sympy.expand(shape.diff(x, 2) ** 2), (x, 0, L)) * (w - a) ** 2 * h**2 / 12
    energy = ((longer - eps) ** 2 * L + bending) / 2  # of E A = 1
    critical = sympy.pi**2 * h**2 / (3 * L**2)
    force = eps - sympy.pi**2 * (w**2 - a**2) / (4 * L**2) - critical * (1 - a / w)
    assert sympy.simplify(energy.diff(w) + force * w * sympy.pi**2 / (2 * L)) == 0
    return sympy.lambdify((w, a, eps, h, L), force, "mpmath")


def entries():
    """The column at shares of its critical load, and the heated rod with two amplitudes."""
    amplitude, residual = column(), heated()
    with mp.workdps(value.WORKING):
        L, h, w, E, a = (value.exact(COLUMN[name]) for name in ("L", "h", "w", "E", "a"))
        EI, GA = E * w * h**3 / 12, E / 2 * w * h
        critical = 1 / (L**2 / (mp.pi**2 * EI) + 1 / GA)
        for share in SHARES:
            P = value.exact(float(value.exact(share) * critical))
            yield {
                "id": f"imperfect-column-{share}",
                "tags": ["statics", "imperfection", "column"],
                "problem": f"middle of a pinned column that is bowed at the start, at {share} of its critical load",
                "source": SOURCE,
                "parameters": COLUMN | {"P": float(P)},
                "values": {"middle.w": value.analytic("m", amplitude(P, EI, GA, L, a))},
            }
        L, h, alpha = (value.exact(HEATED[name]) for name in ("L", "h", "alpha"))
        dT = float(TIMES_CRITICAL * mp.pi**2 * h**2 / (3 * L**2) / alpha)
        eps = alpha * value.exact(dT)
        for start in AMPLITUDES:
            a = value.exact(start)
            straight = 2 * L / mp.pi * mp.sqrt(eps - mp.pi**2 * h**2 / (3 * L**2))
            bow = findroot(lambda w: residual(w, a, eps, h, L), straight)
            yield {
                "id": f"imperfect-heated-{start:g}",
                "tags": ["statics", "imperfection", "heated"],
                "problem": f"middle of a clamped rod that is bowed by {start:g} m at the start, heated to {TIMES_CRITICAL} times its "
                           "critical temperature",
                "source": SOURCE,
                "parameters": HEATED | {"a": start, "dT": dT},
                "values": {"middle.w": value.analytic("m", bow)},
            }
