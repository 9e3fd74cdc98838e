"""`fixtures/references.json`: reference solutions of statics and vibration, from the files of this folder.

Each file treats one problem and yields entries: problem, source, parameters in SI and values. A value is found by two
methods that share only the statement of the problem (`value.agreed`), or derived symbolically and evaluated
(`value.analytic`). None of (9)-(22) is used. Files about the paper's element start from the field r(x, 0) + y d(x) of
(A.1) and from the strain energy.
"""

import platform

import mpmath
import sympy

from ..fixtures import fixture
from . import (
    circle,
    director,
    elastica,
    frequency,
    heated_rod,
    imperfection,
    prestressed,
    reissner,
    timoshenko,
)

FILE = "references.json"

PROBLEMS = (elastica, reissner, director, timoshenko, circle, heated_rod, frequency, imperfection, prestressed)


def generate():
    """The fixture."""
    entries = [entry for problem in PROBLEMS for entry in problem.entries()]
    ids = [entry["id"] for entry in entries]
    assert len(set(ids)) == len(ids), "ids must be unique"
    return {
        "schema": "ancf-references/1",
        "title": "Reference solutions for planar beams: statics, heat, vibration",
        "generator": {
            "command": "python -m oracle references",
            "python": ".".join(platform.python_version_tuple()[:2]),
            "sympy": sympy.__version__,
            "mpmath": mpmath.__version__,
        },
        "conventions": {
            "units": "SI: m, s, kg, N, K, rad; each value has its own",
            "axes": "x along the rod at first, clamped at x = 0 where it is a cantilever; y upwards; forces act "
            "downwards and keep their direction",
            "value": "decimal: rounded, without digits that are not certain; f64: the nearest double",
            "provenance": "analytic: a closed form, derived symbolically from the statement of the problem; numeric: "
            "two methods were run and agree within `agreement`",
            "agreement": "a bound of the methods' relative distance, asserted when this file is written; of a value "
            "below 1e-9 times the largest of its entry the bound is of that largest; null for a closed form",
            "symbols": "L length, h height, w width, E modulus, nu Poisson's ratio, G = E/(2 (1 + nu)), A = w h, "
            "I = w h^3/12, k shear correction factor, a amplitude of a stress-free bow at the start, rho density, alpha expansion, dT heating",
            "k": "null: rigid in shear",
            "stretch": "length over initial length: of the paper's element without stress the root of 1 + 2 alpha dT in a heated "
            "direction, as its strain is Green and Lagrange's; of Euler and Bernoulli's 1 + alpha dT",
            "thickness": "height over initial height, |r_y|: 1 where the section is as it was",
            "N": "axial force, the derivative of the energy by the length: positive in tension, negative in a heated rod "
            "between walls",
            "edits": "never by hand: the command under generator writes this file, and with --check compares it",
        },
        "entries": entries,
    }


def differences(stored, fresh):
    """Differences, except in the versions of the tools; rounding does not reach the stored digits."""
    tools = {"python", "sympy", "mpmath"}
    kept = {tool: version for tool, version in stored.get("generator", {}).items() if tool in tools}
    return fixture.differences(stored, fresh | {"generator": fresh["generator"] | kept})
