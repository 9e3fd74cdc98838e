"""First bending frequencies of the rod of Table 1, simply supported and free.

Euler and Bernoulli: E I v'''' = rho A omega^2 v. Simply supported, omega = (n pi/L)^2 sqrt(E I/(rho A)); free,
omega = (b_n/L)^2 sqrt(E I/(rho A)) with cosh b cos b = 1.

Timoshenko: k G A (v'' - phi') + rho A omega^2 v = 0, E I phi'' + k G A (v' - phi) + rho I omega^2 phi = 0. Simply
supported, v ~ sin(b x), phi ~ cos(b x), b = n pi/L:

    omega^4 rho A rho I/(k G A) - omega^2 (rho A + b^2 (rho I + rho A E I/(k G A))) + E I b^4 = 0,

the smaller root. Free, below the cut-off omega^2 = k G A/(rho I), with O = rho omega^2/(k G), R = rho omega^2/E
and the roots p^2, -q^2 of X^2 + (O + R) X + O R - rho A omega^2/(E I) = 0, from v = cosh(p x) and cos(q x), or sinh
and sin, about the middle:

    p (p^2 + O) tan(q L/2) + q (q^2 - O) tanh(p L/2) = 0     symmetric
    p (p^2 + O) tanh(p L/2) - q (q^2 - O) tan(q L/2) = 0     antisymmetric

The second method is that of Rayleigh and Ritz with Legendre polynomials. It needs only the energies, because a free rod
has no end conditions that trial functions must satisfy.
"""

import numpy as np
import sympy
from mpmath import mp, mpf

from . import value

SOURCE = "Timoshenko 1921, 1922; Young and Felgar 1949 (free rod); parameters: Table 1 of Peng et al. 2018"
TABLE_1 = {"L": 1.0, "h": 0.02, "w": 0.02, "E": 2e8, "nu": 0.0, "rho": 7750.0}

MODES = 5
# Legendre polynomials of v, and of phi.
DEGREE = 32


class Rod:
    """E I, k G A with k = 1, rho A, rho I and L."""

    def __init__(self):
        L, h, w, E, rho = (value.exact(TABLE_1[name]) for name in ("L", "h", "w", "E", "rho"))
        A, I = w * h, w * h**3 / 12
        self.L, self.EI, self.kGA, self.rhoA, self.rhoI = L, E * I, E / 2 * A, rho * A, rho * I

    def determinant(self, omega, symmetric):
        """Determinant of the free rod's end conditions."""
        square = omega**2
        O, R = self.rhoA * square / self.kGA, self.rhoI * square / self.EI
        half, rest = (O + R) / 2, O * R - self.rhoA * square / self.EI
        root = mp.sqrt(half**2 - rest)
        p, q = mp.sqrt(root - half), mp.sqrt(root + half)
        tan, tanh = mp.tan(q * self.L / 2), mp.tanh(p * self.L / 2)
        if symmetric:
            return p * (p**2 + O) * tan + q * (q**2 - O) * tanh
        return p * (p**2 + O) * tanh - q * (q**2 - O) * tan


def supported(rod):
    """omega_n of the simply supported rod, Euler-Bernoulli and Timoshenko; they must satisfy the equations."""
    EI, kGA, rhoA, rhoI, b, S = sympy.symbols("EI kGA rhoA rhoI b S", positive=True)
    middle = rhoA + b**2 * (rhoI + rhoA * EI / kGA)
    root = sympy.sqrt(middle**2 - 4 * rhoA * rhoI * EI * b**4 / kGA)
    # Smaller root of a quadratic equation without cancellation.
    timoshenko = 2 * EI * b**4 / (middle + root)
    # Matrix for v = V sin(b x), phi = P cos(b x), which must be singular.
    matrix = sympy.Matrix([[rhoA * S - kGA * b**2, kGA * b], [kGA * b, rhoI * S - EI * b**2 - kGA]])
    assert sympy.simplify(matrix.det().subs(S, timoshenko)) == 0
    stiff = sympy.limit(timoshenko.subs(rhoI, 0), kGA, sympy.oo)
    assert sympy.simplify(stiff - EI * b**4 / rhoA) == 0
    arguments = (EI, kGA, rhoA, rhoI, b)
    of_b = {"euler": EI * b**4 / rhoA, "timoshenko": timoshenko}
    of_b = {name: sympy.lambdify(arguments, square, "mpmath") for name, square in of_b.items()}
    numbers = (rod.EI, rod.kGA, rod.rhoA, rod.rhoI)
    return {name: [mp.sqrt(f(*numbers, n * mp.pi / rod.L)) for n in range(1, MODES + 1)] for name, f in of_b.items()}


def free_by_roots(rod, guesses):
    """omega_n of the free rod from the frequency equations; guesses select the roots."""
    euler = []
    for n in range(1, MODES + 1):
        b = mp.findroot(lambda b: mp.cos(b) - 1 / mp.cosh(b), (n + mpf(1) / 2) * mp.pi)
        euler.append((b / rod.L) ** 2 * mp.sqrt(rod.EI / rod.rhoA))
    timoshenko = [
        mp.findroot(lambda omega, n=n: rod.determinant(omega, symmetric=n % 2 == 0), mpf(f"{guess:.6e}"))
        for n, guess in enumerate(map(float, guesses))
    ]
    return {"euler": euler, "timoshenko": timoshenko}


def free_by_ritz(rod):
    """omega_n of the free rod from the energies, with v and phi of opposite parity in Legendre polynomials."""
    v = {parity: _legendre(parity) for parity in (0, 1)}
    euler, timoshenko = [], []
    for parity in (0, 1):
        own, other = v[parity], v[1 - parity]
        # Lengths in units of L/2: a derivative takes a factor 2/L, an integral L/2.
        d, half = 2 / rod.L, rod.L / 2
        bend = [_derivative(_derivative(f)) for f in own]
        euler += _frequencies(
            [[rod.EI * d**4 * _product(f, g) for g in bend] for f in bend],
            [rod.rhoA * _product(f, f) for f in own], (MODES + 1 - parity) // 2)
        # Strains of each unknown: shear v' - phi, curvature phi'.
        shear = [_scaled(d, _derivative(f)) for f in own] + [_scaled(-1, f) for f in other]
        curvature = [[]] * len(own) + [_scaled(d, _derivative(f)) for f in other]
        stiffness = [[half * (rod.kGA * _product(shear[i], shear[j]) + rod.EI * _product(curvature[i], curvature[j]))
                      for j in range(len(shear))] for i in range(len(shear))]
        mass = [half * rod.rhoA * _product(f, f) for f in own] + [half * rod.rhoI * _product(f, f) for f in other]
        timoshenko += _frequencies(stiffness, mass, (MODES + 1 - parity) // 2)
    return {"euler": sorted(euler), "timoshenko": sorted(timoshenko)}


def _legendre(parity):
    """P_n of a parity as coefficients of Legendre polynomials."""
    return [[mpf(0)] * n + [mpf(1)] for n in range(parity, DEGREE, 2)]


def _derivative(f):
    """P_n' = (2 n - 1) P_(n-1) + (2 n - 5) P_(n-3) + ..."""
    result = [mpf(0)] * max(len(f) - 1, 0)
    for n, coefficient in enumerate(f):
        for k in range(n - 1, -1, -2):
            result[k] += (2 * k + 1) * coefficient
    return result


def _scaled(factor, f):
    return [factor * coefficient for coefficient in f]


def _product(f, g):
    """Integral of a product over -1 ... 1."""
    return mp.fsum(2 * a * b / (2 * n + 1) for n, (a, b) in enumerate(zip(f, g)) if a and b)


def _frequencies(stiffness, mass, number):
    """Lowest nonzero frequencies of a stiffness and a diagonal mass, in double precision and then refined.

    Rayleigh quotient iteration converges cubically: each step triples the digits, of which the vectors have seven at first.
    """
    scale = [1 / mp.sqrt(m) for m in mass]
    K = mp.matrix([[a * entry * b for b, entry in zip(scale, row)] for a, row in zip(scale, stiffness)])
    squares, vectors = np.linalg.eigh(np.array(K.tolist(), float))
    # Frequencies of rigid motions are zero up to rounding, 1e-16 of the largest.
    first = int(np.argmax(squares > 1e-14 * squares[-1]))
    frequencies = []
    for place in range(first, first + number):
        x = mp.matrix([mpf(entry) for entry in vectors[:, place].tolist()])
        for _ in range(2):
            square = (x.T * K * x)[0] / (x.T * x)[0]
            x = mp.lu_solve(K - square * mp.eye(len(x)), x)
            x /= mp.norm(x, mp.inf)
        frequencies.append(mp.sqrt((x.T * K * x)[0] / (x.T * x)[0]))
    return frequencies


def entries():
    """Entries for both theories and both supports."""
    methods = ("the roots of the frequency equation", "Rayleigh and Ritz's method with Legendre polynomials")
    units = {f"omega_{n}": "rad/s" for n in range(1, MODES + 1)}
    with mp.workdps(value.WORKING):
        rod = Rod()
        held, ritz = supported(rod), free_by_ritz(rod)
        roots = free_by_roots(rod, ritz["timoshenko"])
        for theory in ("euler", "timoshenko"):
            k = {"k": "1"} if theory == "timoshenko" else {}
            entry = {"source": SOURCE, "parameters": TABLE_1 | k}
            yield {
                "id": f"frequency-supported-{theory}",
                "tags": ["vibration", "supported", theory],
                "problem": f"first {MODES} angular frequencies of bending, both ends simply supported",
                **entry,
                "values": {name: value.analytic(units[name], omega) for name, omega in zip(units, held[theory])},
            }
            first, second = (dict(zip(units, found[theory], strict=True)) for found in (roots, ritz))
            yield {
                "id": f"frequency-free-{theory}",
                "tags": ["vibration", "free", theory],
                "problem": f"first {MODES} angular frequencies of bending, both ends free, above the rigid motions",
                **entry,
                "values": value.agreed(methods, units, first, second),
            }
