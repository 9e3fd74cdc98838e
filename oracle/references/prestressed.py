"""Frequencies and buckling of a straight rod under an axial force or heat, by this project's two theories, nu = 0.

x is the material coordinate, 0 ... L in the initial rod. In equilibrium the rod is straight: stretched by a along and by c
across, with the axial stress S (second Piola-Kirchhoff). Second variation of the energies, per length:

**Paper's element**, r = r_0(x) + y d(x), W = E/2 (E_11^2 + E_22^2 + 2 E_12^2) with E_11, E_22 less alpha dT. With
r_0 = (a x, v), d = (p, c), and S_22 = 0 as the section is free to thicken,

    2 U = (E a^2 + S) I p'^2 + G A (a p + c v')^2 + S A v'^2,    S = E ((a^2 - 1)/2 - alpha dT),    c^2 = 1 + 2 alpha dT,

2 T = rho A v'^2 (in time) + rho I p'^2, G = E/2: Timoshenko's rod with k = 1. The force at the end is P = A a S.

**Euler and Bernoulli's element**, U = EA/2 (|r_x| - 1 - alpha dT)^2 + EI/2 kappa^2, kappa = (r_x x r_xx)/|r_x|^2:

    2 U = E I v''^2/a^2 + N v'^2/a,    N = E A (a - 1 - alpha dT) = P,    2 T = rho A v'^2 (in time).

Loaded: the force P acts at the end that slides. Heated: both ends are held, so that a = 1.
**Supported**, v ~ sin(q x), p ~ cos(q x), q = n pi/L: a closed form. **Clamped** (p = 0, or v' = 0): roots of the
determinant of the end conditions, and Rayleigh and Ritz's method with polynomials that satisfy them.

**Buckling.** omega = 0 has v = sin(q x), q = pi/L, or v = 1 - cos(q x), q = 2 pi/L where clamped. `factor` is where the
true stiffness, at the true a and S, turns singular: E I q^2/a^2 + N/a = 0, or with the coefficients k of
2 U = B p'^2 + k_pp p^2 + 2 k_vp p v' + k_vv v'^2

    k_vv (B q^2 + k_pp) = k_vp^2.

`linearised` is the root of the same with the coefficients' tangents at no load, k(0) + factor k'(0).

A textbook has the Euler load E I q^2, and the frequency sqrt((E I q^4 + P q^2)/(rho A)): `euler`, the entry's load factor and
frequency for comparison, or Engesser's load P_E/(1 + P_E/(G A)): `engesser`. The theory's own differ from these by the order of
the strain P/(E A) and by shear.
"""

import numpy as np
import scipy.linalg
import sympy
from mpmath import mp, mpf

from . import value
from .frequency import _derivative, _product, _scaled

SOURCE = "derived here from the strain energies; Timoshenko and Gere 1961 for Euler's and Engesser's loads"
TABLE_1 = {"L": 1.0, "h": 0.02, "w": 0.02, "E": 2e8, "nu": 0.0, "rho": 7750.0, "alpha": 2.85e-5}
FORCE, HEAT = -13.0, 5.0

MODES = 3
# Polynomials of v, and of p.
DEGREE = 36
THEORIES = ("ancf", "euler-bernoulli")


class Rod:
    """Section, and the coefficients of the second variation under a force and heat."""

    def __init__(self, theory):
        self.theory = theory
        self.L, h, w, self.E, rho, self.alpha = (value.exact(TABLE_1[name]) for name in ("L", "h", "w", "E", "rho", "alpha"))
        self.A, self.I = w * h, w * h**3 / 12
        self.rhoA, self.rhoI = rho * self.A, rho * self.I

    def state(self, P, dT, held):
        """Stretches a and c, and the axial stress S or force N. A heated rod is held, a loaded one slides."""
        theta = self.alpha * dT
        c = mp.sqrt(1 + 2 * theta)
        if self.theory == "ancf":
            def stress(a):
                return self.E * ((a**2 - 1) / 2 - theta)
            a = mpf(1) if held else mp.findroot(lambda a: self.A * a * stress(a) - P, 1 + P / self.E / self.A + theta)
            return a, c, stress(a)
        a = mpf(1) if held else 1 + P / self.E / self.A + theta
        return a, c, self.E * self.A * (a - 1 - theta)

    def coefficients(self, P, dT, held):
        """B, k_pp, k_vp, k_vv of the paper's element; of Euler and Bernoulli's those of v''^2 and v'^2."""
        a, c, S = self.state(P, dT, held)
        E, A, I = self.E, self.A, self.I
        if self.theory == "ancf":
            G = E / 2
            return [(E * a**2 + S) * I, G * A * a**2, G * A * a * c, G * A * c**2 + S * A]
        return [E * I / a**2, S / a]

    def supported(self, k, n):
        """omega_n of the simply supported rod."""
        q = n * mp.pi / self.L
        if self.theory == "euler-bernoulli":
            return mp.sqrt((k[0] * q**4 + k[1] * q**2) / self.rhoA)
        B, k_pp, k_vp, k_vv = k
        v, p = k_vv * q**2, B * q**2 + k_pp
        # The smaller root of (v - rho A W)(p - rho I W) = (k_vp q)^2, W = omega^2.
        middle = (v * self.rhoI + p * self.rhoA) / 2
        rest = v * p - (k_vp * q) ** 2
        return mp.sqrt(rest / (middle + mp.sqrt(middle**2 - self.rhoA * self.rhoI * rest)))

    def determinant(self, k, omega, symmetric):
        """Determinant of the clamped rod's end conditions, from cosh(r x) and sinh(r x)/r about the middle, r^2 = X."""
        W, half = omega**2, self.L / 2
        if self.theory == "euler-bernoulli":
            b, c = k[1] / k[0], self.rhoA * W / k[0]
            roots = [b / 2 + sign * mp.sqrt(b**2 / 4 + c) for sign in (1, -1)]
            slope = [lambda X: X, lambda X: mpf(1)][not symmetric]
        else:
            B, k_pp, k_vp, k_vv = k
            # (k_vv X + rho A W)(B X - k_pp + rho I W) + k_vp^2 X = 0
            first = k_vv * B
            middle = k_vv * (self.rhoI * W - k_pp) + self.rhoA * W * B + k_vp**2
            last = self.rhoA * W * (self.rhoI * W - k_pp)
            root = mp.sqrt(middle**2 - 4 * first * last)
            roots = [(-middle + root) / (2 * first), (-middle - root) / (2 * first)]
            turned = lambda X: -(k_vv * X + self.rhoA * W) / k_vp
            slope = [turned, lambda X: turned(X) / X][not symmetric]
        cosh = [mp.re(mp.cosh(mp.sqrt(X) * half)) for X in roots]
        sinh = [mp.re(mp.sinh(mp.sqrt(X) * half) / mp.sqrt(X)) for X in roots]
        v, p = (cosh, sinh) if symmetric else (sinh, cosh)
        return v[0] * slope(roots[1]) * p[1] - v[1] * slope(roots[0]) * p[0]

    def clamped_by_ritz(self, k):
        """omega_n of the clamped rod from the energies, with polynomials that vanish at its ends."""
        found = []
        d, half = 2 / self.L, self.L / 2
        for parity in (0, 1):
            number = (MODES + 1 - parity) // 2
            if self.theory == "euler-bernoulli":
                v = [_flat(n) for n in range(parity, DEGREE, 2)]
                strains = [(k[0], [_scaled(d**2, _derivative(_derivative(f))) for f in v]),
                           (k[1], [_scaled(d, _derivative(f)) for f in v])]
                K = [[half * mp.fsum(c * _product(s[i], s[j]) for c, s in strains) for j in range(len(v))]
                     for i in range(len(v))]
                M = [[half * self.rhoA * _product(f, g) for g in v] for f in v]
            else:
                v = [_zero(n) for n in range(parity, DEGREE, 2)]
                p = [_zero(n) for n in range(1 - parity, DEGREE, 2)]
                slope = [_scaled(d, _derivative(f)) for f in v] + [[]] * len(p)
                turn = [[]] * len(v) + p
                bend = [[]] * len(v) + [_scaled(d, _derivative(f)) for f in p]
                B, k_pp, k_vp, k_vv = k
                size = range(len(slope))
                K = [[half * (B * _product(bend[i], bend[j]) + k_pp * _product(turn[i], turn[j])
                              + k_vp * (_product(turn[i], slope[j]) + _product(slope[i], turn[j]))
                              + k_vv * _product(slope[i], slope[j])) for j in size] for i in size]
                zero = [[]] * len(v) + p, v + [[]] * len(p)
                M = [[half * (self.rhoI * _product(zero[0][i], zero[0][j]) + self.rhoA * _product(zero[1][i], zero[1][j]))
                      for j in size] for i in size]
            found += _pencil(K, M, number)
        return sorted(found)

    def clamped(self, k, guesses):
        """omega_n from the determinant; the guesses select its roots."""
        return [mp.findroot(lambda omega, n=n: self.determinant(k, omega, n % 2 == 0), mpf(f"{float(guess):.6e}"))
                for n, guess in enumerate(guesses)]

    def singular(self, k, q):
        """What is zero where the rod buckles."""
        if self.theory == "euler-bernoulli":
            return k[0] * q**2 + k[1]
        B, k_pp, k_vp, k_vv = k
        return (k_vv * (B * q**2 + k_pp) - k_vp**2) / k_pp

    def tangents(self, held):
        """k(0) and k'(0) under the whole load, symbolically from the state's own equations."""
        s, E, A, I, P, t, a_1 = sympy.symbols("s E A I P t a_1", real=True)
        a, c = (sympy.Integer(1) if held else 1 + a_1 * s), sympy.sqrt(1 + 2 * t * s)
        if self.theory == "ancf":
            S = E * ((a**2 - 1) / 2 - t * s)
            k = [(E * a**2 + S) * I, E / 2 * A * a**2, E / 2 * A * a * c, E / 2 * A * c**2 + S * A]
            balance = A * a * S - s * P
        else:
            N = E * A * (a - 1 - t * s)
            k = [E * I / a**2, N / a]
            balance = N - s * P
        known = {} if held else {a_1: sympy.solve(balance.diff(s).subs(s, 0), a_1)[0]}
        return [sympy.lambdify((E, A, I, P, t), [f.subs(s, 0).subs(known) for f in (k if order == 0 else [f.diff(s) for f in k])],
                               "mpmath") for order in (0, 1)]


def _zero(n):
    """P_n - P_(n + 2): vanishes at both ends."""
    return [mpf(0)] * n + [mpf(1), mpf(0), mpf(-1)]


def _flat(n):
    """A polynomial that vanishes at both ends with its derivative."""
    return [mpf(0)] * n + [mpf(1), mpf(0), -mpf(2 * (2 * n + 5)) / (2 * n + 7), mpf(0), mpf(2 * n + 3) / (2 * n + 7)]


def _pencil(stiffness, mass, number):
    """Lowest frequencies, in double precision and then by Rayleigh quotient iteration."""
    scale = [1 / mp.sqrt(mass[i][i]) for i in range(len(mass))]
    K, M = (mp.matrix([[a * entry * b for b, entry in zip(scale, row)] for a, row in zip(scale, of)]) for of in (stiffness, mass))
    _, vectors = scipy.linalg.eigh(np.array(K.tolist(), float), np.array(M.tolist(), float))
    frequencies = []
    for place in range(number):
        x = mp.matrix([mpf(entry) for entry in vectors[:, place].tolist()])
        for _ in range(3):
            square = (x.T * K * x)[0] / (x.T * M * x)[0]
            x = mp.lu_solve(K - square * M, M * x)
            x /= mp.norm(x, mp.inf)
        frequencies.append(mp.sqrt((x.T * K * x)[0] / (x.T * M * x)[0]))
    return frequencies


def frequencies(theory):
    """Entries: both supports without load, under the force and under heat."""
    rod = Rod(theory)
    units = {f"omega_{n}": "rad/s" for n in range(1, MODES + 1)}
    methods = ("the roots of the frequency equation", "Rayleigh and Ritz's method with polynomials")
    for state, P, dT in (("cold", 0, 0), ("loaded", value.exact(FORCE), 0), ("heated", 0, value.exact(HEAT))):
        k = rod.coefficients(P, dT, held=state == "heated")
        load = {"cold": {}, "loaded": {"P": FORCE}, "heated": {"dT": HEAT, "model": "2d"}}[state]
        under = {"cold": "", "loaded": ", under an axial force at the end that slides", "heated": ", heated between its supports"}
        entry = {"source": SOURCE, "parameters": TABLE_1 | load}
        yield {
            "id": f"modes-supported-{state}-{theory}",
            "tags": ["modes", "supported", state, theory],
            "problem": f"first {MODES} angular frequencies of bending, simply supported{under[state]}",
            **entry,
            "values": {name: value.analytic(unit, rod.supported(k, n)) for n, (name, unit) in enumerate(units.items(), 1)},
        }
        ritz = rod.clamped_by_ritz(k)
        first, second = (dict(zip(units, found, strict=True)) for found in (rod.clamped(k, ritz), ritz))
        yield {
            "id": f"modes-clamped-{state}-{theory}",
            "tags": ["modes", "clamped", state, theory],
            "problem": f"first {MODES} angular frequencies of bending, clamped{under[state]}",
            **entry,
            "values": value.agreed(methods, units, first, second, digits=18),
        }


def buckling(theory):
    """Entries: factors of the force and of heat at which the rod buckles, for both supports."""
    rod = Rod(theory)
    for support, waves in (("supported", 1), ("clamped", 2)):
        q = waves * mp.pi / rod.L
        euler = rod.E * rod.I * q**2
        for load, P, dT in (("loaded", value.exact(FORCE), 0), ("heated", 0, value.exact(HEAT))):
            held = load == "heated"
            # Force or heat at which Euler's rod buckles, over the entry's.
            textbook = euler / (rod.E * rod.A * rod.alpha * dT) if held else -euler / P
            factor = mp.findroot(lambda s: rod.singular(rod.coefficients(s * P, s * dT, held), q), textbook)
            constants = (rod.E, rod.A, rod.I, P, rod.alpha * dT)
            start, rate = (of(*constants) for of in rod.tangents(held))
            linearised = mp.findroot(lambda s: rod.singular([k + s * k_1 for k, k_1 in zip(start, rate)], q), textbook)
            engesser = textbook / (1 + euler / (rod.E / 2 * rod.A))
            yield {
                "id": f"buckling-{support}-{load}-{theory}",
                "tags": ["buckling", support, load, theory],
                "problem": f"factor of the {'heat' if held else 'axial force'} at which the straight rod buckles, {support}",
                "source": SOURCE,
                "parameters": TABLE_1 | ({"dT": HEAT, "model": "2d"} if held else {"P": FORCE}),
                "values": {name: value.analytic("1", found) for name, found in
                           (("factor", factor), ("linearised", linearised), ("euler", textbook), ("engesser", engesser))},
            }


def entries():
    """Entries of both theories."""
    with mp.workdps(value.WORKING):
        for theory in THEORIES:
            yield from frequencies(theory)
            yield from buckling(theory)
