"""`fixtures/calculix.json`: the pendulum of Table 1 as a plane solid in CalculiX, a program independent of this project.

CalculiX integrates CPE8 (eight nodes, plane strain; at nu = 0 equal to plane stress) as the brick C3D20 with 3 x 3 x 3
Gauss points. With ALPHA=0 its implicit dynamics are the trapezoidal rule. `newmark` applies this rule on the same mesh
with the same step. If both are right, they differ only by rounding, by CalculiX's stopping criterion and by the seven
digits that it prints. So their distance tests the forces of `solid` at any mesh and step.

Heat enters as the equivalent stress of this law, S0 = -E alpha dT in the heated directions. CalculiX's own thermal
expansion is not invariant under rotation for nonlinear strains.
"""

import os
import platform
import re
import shutil
import subprocess
import tempfile
from importlib.metadata import version
from math import cos, sin, sqrt
from pathlib import Path

import numpy as np

from ..fixtures import fixture
from ..fixtures.fixture import settled
from ..motion.beam import HEATED_DIRECTIONS
from ..motion.hinged_rod import TABLE_1
from .newmark import ImplicitRod, motion
from .solid import Rod

FILE = "calculix.json"
PROGRAM = "ccx"
TOOLS = ("numpy", "scipy", "scikit-fem")

# Id, model, start, elements along and across, step (s), end (s).
CASES = [
    ("flexible", "none", None, 40, 2, 5e-4, 2.0),
    ("2d-relaxed", "2d", "relaxed", 40, 2, 5e-4, 0.5),
    # CalculiX's iteration fails on the shock at 1e-3 s, `newmark` at 2e-4 s.
    ("2d-sudden", "2d", "sudden", 40, 1, 1e-4, 0.5),
]
INTERVAL = 0.01
# Duration (s) of the static step before a relaxed start; it has no effect.
PERIOD = 1.0
WINDOWS = ((0.0, 0.25), (0.25, 0.5), (0.5, 1.0), (1.0, 1.5), (1.5, 2.0))

# Largest distance (m) of CalculiX from `newmark`; an error of 0.1 % in the modulus moves the tip by 1e-4 m in 0.5 s.
BAR = 1e-5
# Allowance (m) for CalculiX on another machine, which prints seven digits of displacements up to 2 m.
ROUNDING = 5e-6
# Allowance for its stresses, which are 3 to 40 in `law`.
LAW_DIGITS = 1e-4
# Allowance (m) for `newmark` on another machine.
REPEATED = 1e-8
# Duration (s) that a check of all fixtures repeats with `newmark`.
SHORT = 0.1

# Largest residual relative to the average force, and last correction relative to the increment; defaults are 5e-3, 1e-2.
CONTROLS = (1e-8, 1e-6)
GAUSS_POINTS = 27


def stress_free(model):
    """Squared stress-free stretches along and across."""
    return [1 + 2 * heated * TABLE_1["alpha"] * TABLE_1["dT"] for heated in HEATED_DIRECTIONS[model]]


def stretches(model, start):
    """Stretches along and across at t = 0."""
    return [sqrt(square) if start == "relaxed" else 1.0 for square in stress_free(model)]


def number(x):
    """A number in at most 20 characters, the most that CalculiX reads."""
    return f"{float(x):.13e}"


def nodes_and_elements(along, across):
    """Nodes (i, j) on a grid of half elements, numbered from 1, and elements with their nodes in CalculiX's order."""
    nodes = {}
    for i in range(2 * along + 1):
        for j in range(2 * across + 1):
            if i % 2 == 0 or j % 2 == 0:
                nodes[i, j] = len(nodes) + 1
    around = ((0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1))
    elements = [[nodes[2 * i + di, 2 * j + dj] for di, dj in around] for i in range(along) for j in range(across)]
    return nodes, elements


def solid_lines(points, elements, E, rho, w):
    """Lines of the deck for nodes, elements and material."""
    return [
        "*NODE, NSET=ALL", *(f"{k}, {number(x)}, {number(y)}" for k, (x, y) in points.items()),
        "*ELEMENT, TYPE=CPE8, ELSET=ROD", *(f"{k}, " + ", ".join(map(str, e)) for k, e in enumerate(elements, 1)),
        "*MATERIAL, NAME=TABLE1", "*ELASTIC", f"{number(E)}, 0.0", "*DENSITY", number(rho),
        "*SOLID SECTION, ELSET=ROD, MATERIAL=TABLE1", number(w),
    ]


def stress_lines(count, S11, S22, S12=0.0):
    """Lines for a uniform initial stress, which CalculiX takes as second Piola-Kirchhoff stress."""
    return ["*INITIAL CONDITIONS, TYPE=STRESS"] + [
        f"{element}, {point}, {number(S11)}, {number(S22)}, 0.0, {number(S12)}, 0.0, 0.0"
        for element in range(1, count + 1) for point in range(1, GAUSS_POINTS + 1)]


def deck(model, start, along, across, step, end):
    """The input deck of one case."""
    L, h, w, rho, E, g = (TABLE_1[name] for name in ("L", "h", "w", "rho", "E", "g"))
    nodes, elements = nodes_and_elements(along, across)
    points = {k: (i * L / (2 * along), h * (j / (2 * across) - 0.5)) for (i, j), k in nodes.items()}
    lines = solid_lines(points, elements, E, rho, w)
    # The hinged face is y d: its displacement is linear across. The last node carries d.
    lines += ["*EQUATION"]
    for j in range(2 * across):
        if j != across:
            share = (j - across) / across
            lines += [f"2\n{nodes[0, j]}, {k}, 1.0, {nodes[0, 2 * across]}, {k}, {number(-share)}" for k in (1, 2)]
    hinge = [f"{nodes[0, across]}, 1, 2"]
    controls = ["*CONTROLS, PARAMETERS=FIELD", ", ".join(map(number, CONTROLS))]
    lines += ["*BOUNDARY", *hinge]
    if model != "none":
        lines += stress_lines(len(elements), *(E / 2 * (1 - square) for square in stress_free(model)))
    tip = nodes[2 * along, across]
    if start == "relaxed":
        # A static step without weight and with the tip held in height, because CalculiX diverges from initial displacements
        # of this element. Dynamics need energies, which CalculiX requires to be requested from the first step on.
        lines += ["*STEP, NLGEOM", "*STATIC, DIRECT", f"{PERIOD}, {PERIOD}", *controls, "*BOUNDARY", f"{tip}, 2",
                  "*EL PRINT, ELSET=ROD, TOTALS=ONLY", "ELSE", "*END STEP"]
    return "\n".join([
        *lines,
        "*STEP, NLGEOM, INC=100000000",
        "*DYNAMIC, DIRECT, ALPHA=0.0", f"{number(step)}, {number(end)}",
        *controls,
        "*BOUNDARY, OP=NEW", *hinge, "*DLOAD", f"ROD, GRAV, {number(g)}, 0.0, -1.0, 0.0",
        "*NSET, NSET=TIP", str(tip),
        f"*NODE PRINT, NSET=TIP, FREQUENCY={round(INTERVAL / step)}", "U",
        "*END STEP", ""])


def run(text):
    """Runs CalculiX on a deck with one thread; returns the lines that it printed."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "rod.inp").write_text(text)
        with open(Path(folder) / "log", "w") as log:
            code = subprocess.run([PROGRAM, "rod"], cwd=folder, stdout=log, stderr=log,
                                  env=os.environ | {"OMP_NUM_THREADS": "1"}).returncode
        if code:
            end = (Path(folder) / "log").read_text()[-500:]
            raise ArithmeticError(f"{PROGRAM} ended with code {code}: {end}")
        return (Path(folder) / "rod.dat").read_text().splitlines()


def rows(lines, start):
    """Time and first row of numbers under each heading that begins with `start`."""
    headings = [k for k, line in enumerate(lines) if line.strip().startswith(start)]
    return [(float(lines[k].split()[-1]), [float(part) for part in lines[k + 2].split()[1:]]) for k in headings]


def tip_by_calculix(case):
    """Tip positions by CalculiX every INTERVAL, from t = 0."""
    _, model, start, along, across, step, end = case
    printed = rows(run(deck(model, start, along, across, step, end)), "displacements")
    times = np.arange(1, round(end / INTERVAL) + 1) * INTERVAL + PERIOD * (start == "relaxed")
    assert np.allclose([t for t, _ in printed], times, rtol=1e-6, atol=0), "CalculiX stopped early"
    initial = TABLE_1["L"] * stretches(model, start)[0]
    return [[initial, 0.0]] + [[round(TABLE_1["L"] + u[0], 12), u[1]] for _, u in printed]


def tip_by_newmark(case, end):
    """Tip positions by `newmark` every INTERVAL until `end`, to the nanometre."""
    _, model, start, along, across, step, _ = case
    rod = ImplicitRod(Rod(*(TABLE_1[name] for name in Rod._fields)), along, across, stress_free(model))
    unknowns = rod.straight(*stretches(model, start))
    states = motion(rod, unknowns, step, round(INTERVAL / step), round(end / INTERVAL))
    return [rod.tip(q).round(9).tolist() for q in states]


def law():
    """CalculiX's stress law: one element, stretched, sheared and rotated by 2 rad, with an initial stress."""
    E, S0 = 200.0, [[-5.0, 3.0], [3.0, -7.0]]
    F = np.array([[cos(2), -sin(2)], [sin(2), cos(2)]]) @ [[1.2, 0.1], [0.0, 0.9]]
    nodes, elements = nodes_and_elements(1, 1)
    points = {k: (i / 2, j / 2) for (i, j), k in nodes.items()}
    held = [f"{k}, {c + 1}, {c + 1}, {number((F @ at - at)[c])}" for k, at in points.items() for c in (0, 1)]
    lines = run("\n".join([
        *solid_lines(points, elements, E, 1.0, 1.0), *stress_lines(1, S0[0][0], S0[1][1], S0[0][1]),
        "*STEP, NLGEOM", "*STATIC, DIRECT", "1.0, 1.0", "*BOUNDARY", *held,
        "*EL PRINT, ELSET=ROD", "S", "*END STEP", ""]))
    S11, S22, _, S12 = rows(lines, "stresses")[0][1][1:5]
    return {"E": E, "S0": S0, "F": F.tolist(), "cauchy": [[S11, S12], [S12, S22]]}


def entry(case, calculix, scikit_fem):
    """One run of the fixture."""
    name, model, start, along, across, step, end = case
    distance = np.linalg.norm(np.subtract(calculix, scikit_fem), axis=1)
    assert distance.max() < BAR, f"{name}: CalculiX and scikit-fem are {distance.max()} m apart"
    of_window = [distance[round(a / INTERVAL):round(b / INTERVAL) + 1].max() for a, b in WINDOWS if b <= end]
    return {
        "id": name, "model": model, "start": start, "elements": [along, across], "step": step,
        "t": [round(k * INTERVAL, 2) for k in range(len(calculix))],
        "calculix": calculix, "scikit_fem": scikit_fem,
        "agreement": [float(f"{largest:.1e}") for largest in of_window],
    }


def program():
    """Version of CalculiX, or None where it is not installed."""
    if shutil.which(PROGRAM) is None:
        return None
    return re.search(r"Version ([\d.]+)", subprocess.run([PROGRAM, "-v"], capture_output=True, text=True).stdout)[1]


def generate():
    """The fixture; CalculiX takes 20 to 40 minutes."""
    if program() is None:
        raise SystemExit(f"skipped: {PROGRAM} (CalculiX) is not installed; fixtures/{FILE} is unchanged")
    return document(program(), law(), [(tip_by_calculix(case), tip_by_newmark(case, case[-1])) for case in CASES])


def check():
    """The stored fixture with scikit-fem's numbers recomputed until SHORT. Only `generate` runs CalculiX."""
    try:
        stored = fixture.read(FILE)
    except (OSError, ValueError):
        return {}  # the comparison reports why
    if stored.pop("sha256", None) != fixture.digest(stored):
        return stored  # the comparison reports it
    print(f"skipped: {PROGRAM} (CalculiX) runs only by name; its stored numbers are used", flush=True)
    tips = []
    for case, run in zip(CASES, stored["runs"], strict=True):
        again = tip_by_newmark(case, SHORT)
        tips.append((run["calculix"], again + run["scikit_fem"][len(again):]))
    return document(stored["generator"]["calculix"], stored["law"], tips)


def differences(stored, fresh):
    """Differences, except in the versions of the tools and in digits that rounding explains."""
    tools = {"calculix", "python", *TOOLS}
    kept = {tool: number for tool, number in stored.get("generator", {}).items() if tool in tools}
    fresh = fresh | {"generator": fresh["generator"] | kept}
    runs = {"calculix": ROUNDING, "scikit_fem": REPEATED, "agreement": ROUNDING}
    return fixture.differences(settled(stored, fresh, {"law": LAW_DIGITS, "runs": runs}), fresh)


def document(program, law, tips):
    """The fixture from CalculiX's version, its stress in `law`, and pairs of tips."""
    E, S0, F, cauchy = (np.array(law[name]) for name in ("E", "S0", "F", "cauchy"))
    expected = F @ (E / 2 * (F.T @ F - np.eye(2)) + S0) @ F.T / np.linalg.det(F)
    assert np.allclose(cauchy, expected, rtol=1e-6, atol=0), f"the stress of CalculiX is {cauchy}, not {expected}"
    return {
        "schema": "ancf-calculix/1",
        "title": "The pendulum of Table 1 as a plane solid, by CalculiX and by scikit-fem on the same mesh",
        "source": "Peng, Wang, Li, Zhi, Li 2018, doi 10.1155/2018/1752815, Table 1",
        "generator": {
            "command": "python -m oracle calculix",
            "calculix": program,
            "python": ".".join(platform.python_version_tuple()[:2]),
            **{tool: version(tool) for tool in TOOLS},
        },
        "settings": {
            "element": "CPE8, which CalculiX integrates as C3D20 with 3 x 3 x 3 Gauss points; ElementQuadS2 in "
            "scikit-fem, 3 x 3. Rectangles, `elements` along and across the rod",
            "mass": "consistent",
            "time": "*DYNAMIC, DIRECT, ALPHA=0: trapezoidal rule, fixed `step` (s)",
            "controls": "*CONTROLS, PARAMETERS=FIELD: {:g}, {:g}".format(*CONTROLS),
            "solver": "SPOOLES",
            "heat": "*INITIAL CONDITIONS, TYPE=STRESS: S0 = -E alpha dT in the heated directions",
            "relaxed": "a *STATIC step without weight, the tip's height held, to the stress-free stretch",
            "hinge": "r(0, y) = y d by *EQUATION on the nodes of the face x = 0, with d free",
        },
        "conventions": {
            "units": "SI: m, s, kg, K",
            "axes": "x along the rod at first, y upwards; gravity is (0, -g)",
            "calculix, scikit_fem": "position of the axis point at x = L, for each t; CalculiX prints seven "
            "digits of its displacement",
            "agreement": f"largest distance between the two over each of `windows`, m; {BAR:g} is an error",
            "law": "E_AB Green-Lagrange, S = E E_AB + S0 at nu = 0 on one element under F; cauchy is CalculiX's "
            "stress, which has to be F S F^T / det F",
            "edits": "never by hand: the command under generator writes this file; --check repeats what needs no "
            "CalculiX, and named with --check, all of it",
        },
        "parameters": TABLE_1,
        "windows": [list(window) for window in WINDOWS],
        "law": law,
        "runs": [entry(case, *pair) for case, pair in zip(CASES, tips, strict=True)],
    }
