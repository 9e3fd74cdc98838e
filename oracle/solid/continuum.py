"""`fixtures/continuum.json`: the pendulum of Table 1 as a plane solid, with its uncertainty window by window.

No equation of the beam is used: the section may warp and thicken. `python -m oracle continuum` takes a quarter of an hour
on one core, too long for every check. `--check` repeats a coarse level, which must agree with the stored one and must be
as close to the stored fine curves as it was.

Observed: order 4 in length and height of the elements for the flexible and the relaxed models; their error in time is
3e-9 m. Sudden models have wave fronts, so that their highest waves are never resolved and no order shows. Each refinement
moves their tip by about 3e-5 m before 0.5 s, as does plain velocity Verlet at 5e-6 s.

The hinge matters (mesh 50 x 2, before 0.5 s). A hinge at a single node changes the tip by 1 cm in sudden models and by
4e-5 m in the others; a face that cannot stretch changes it by 2e-5 m and 1e-10 m.
"""

import platform
import time
from importlib.metadata import version
from math import ceil, floor, log10, sqrt
from typing import NamedTuple

import numpy as np

from ..fixtures import fixture
from ..motion.beam import HEATED_DIRECTIONS
from ..motion.hinged_rod import TABLE_1
from . import sanity
from .solid import Rod, Solid, motion

FILE = "continuum.json"
TOOLS = ("numpy", "scipy", "scikit-fem")

MODELS = {
    "flexible": ("none", None),
    "1d-sudden": ("1d", "sudden"),
    "1d-relaxed": ("1d", "relaxed"),
    "2d-sudden": ("2d", "sudden"),
    "2d-relaxed": ("2d", "relaxed"),
}

INTERVAL = 0.01  # between samples
SAMPLES = 200
WINDOWS = ((0.0, 0.25), (0.25, 0.5), (0.5, 1.0), (1.0, 1.5), (1.5, 2.0))


class Level(NamedTuple):
    """A mesh, and the number of time steps per interval."""

    along: int
    across: int
    splits: int

    def described(self):
        """The level as the fixture describes it."""
        return {"along": self.along, "across": self.across, "step": INTERVAL / self.splits}


LEVELS = {
    "fine": Level(100, 4, 800),
    "half across": Level(100, 2, 800),
    "half across, double along": Level(200, 2, 800),
    "half across, double step": Level(100, 2, 400),
}
COARSE = Level(50, 2, 400)
COARSE_SAMPLES = 100
COARSE_STRIDE = 5  # intervals between stored samples: 0.05 s

# Tolerance of a check of the coarse curve: factor on the observed rounding, for another machine; and rounding of storage (m).
ROUNDING_FACTOR, STORED = 30, 1e-9

CONVENTIONS = {
    "units": "SI: m, s, kg, K",
    "axes": "x along the rod at first, y upwards; gravity is (0, -g)",
    "rod": "plane solid 0 <= x <= L, |y| <= h/2 of breadth w; `along` x `across` quadrilaterals of 9 nodes, "
           "3 x 3 Gauss points, diagonal mass by Simpson's rule",
    "law": "total Lagrangian, S = E (E_GL - E_T) (nu = 0), with E_T = alpha dT I for 2d, alpha dT t t^T with t the "
           "initial axis for 1d, zero for none",
    "hinge": "the face x = 0 is y d with a free vector d: it stays straight, and turns and stretches",
    "start": "at rest, horizontal. sudden: unstretched, dT acts from t = 0. relaxed: at the stress-free stretch "
             "sqrt(1 + 2 alpha dT) in the heated directions. null: no heat",
    "time": "velocity Verlet with the acceleration taken at r + step^2/12 r'', of order four for linear vibrations",
    "tip": "the material point (L, 0), every `interval` from t = 0, x before y, at level fine",
    "uncertainty": "of the tip, m, for each window: from the largest distances over its samples, its start not "
                   "counted. mesh: of fine from half across, plus of half across from half across, double along. "
                   "step: of half across from half across, double step. total: their sum. No order is assumed. It is "
                   "the uncertainty of the solution of the solid's equations, not of the model",
    "coarse": "for a quick check: tip at its own interval; error: largest distance from the fine curve, plus that "
              "curve's total, for each window that it reaches; rounding: largest distance from the same run in other "
              "units (lengths times 3, E times 9), which moves alike and rounds differently",
    "edits": "never by hand: the command under generator writes this file, and with --check repeats its coarse level",
}


def tips(level, samples=SAMPLES, scale=1.0):
    """The tip, (model, sample, component), computed with all lengths multiplied by `scale`."""
    start = time.perf_counter()
    L, h, w, rho, E, g = (TABLE_1[name] for name in Rod._fields)
    stretches = [[1 + 2 * heated * TABLE_1["alpha"] * TABLE_1["dT"] for heated in HEATED_DIRECTIONS[model]]
                 for model, _ in MODELS.values()]
    starts = [[sqrt(c) if begin == "relaxed" else 1.0 for c in squares]
              for squares, (_, begin) in zip(stretches, MODELS.values())]
    rod = Rod(scale * L, scale * h, w, rho, scale**2 * E, scale * g)
    solid = Solid(rod, level.along, level.across, np.transpose(stretches))
    step = INTERVAL / level.splits
    assert step < 0.9 * solid.stable_step()
    states = motion(solid, solid.straight(*np.transpose(starts)), step, level.splits, samples)
    curves = np.array([r[:, solid.tip] for r, _ in states]).transpose(2, 0, 1) / scale
    seconds = time.perf_counter() - start
    print(f"solved   {seconds:6.1f} s  solid of {level.along} x {level.across}, step {step:g} s", flush=True)
    return curves


def windowed(distances, stride=1):
    """Largest distance in each window whose end the samples reach; they are `stride` intervals apart."""
    samples = [round(end / INTERVAL / stride) for _, end in WINDOWS]
    starts = [0, *samples]
    return [float(max(distances[a + 1:b + 1])) for a, b in zip(starts, samples) if b < len(distances)]


def upwards(values):
    """Values rounded up to two digits."""
    units = [10.0 ** (floor(log10(value)) - 1) for value in values]
    return [float(f"{ceil(value / unit) * unit:.1e}") for value, unit in zip(values, units)]


def distance(a, b):
    """Distances between two curves, sample by sample."""
    return np.linalg.norm(a - b, axis=-1)


def head():
    """The entries of the fixture that need no long computation."""
    return {
        "schema": "ancf-continuum/1",
        "title": "The pendulum of Table 1 as a plane solid, elastic and heated, with its uncertainty",
        "source": "Peng, Wang, Li, Zhi, Li 2018, doi 10.1155/2018/1752815, Table 1",
        "generator": {
            "command": "python -m oracle continuum",
            "python": ".".join(platform.python_version_tuple()[:2]),
            **{tool: version(tool) for tool in TOOLS},
        },
        "conventions": CONVENTIONS,
        "parameters": TABLE_1,
        "levels": {name: level.described() for name, level in LEVELS.items()},
        "interval": INTERVAL,
        "windows": [list(window) for window in WINDOWS],
    }


def coarse(curves):
    """The coarse level as stored."""
    return COARSE.described() | {
        "interval": COARSE_STRIDE * INTERVAL,
        "tip": dict(zip(MODELS, curves[:, ::COARSE_STRIDE].round(9).tolist())),
    }


def runs():
    """The fine curves with their uncertainties."""
    curves = {name: tips(level) for name, level in LEVELS.items()}
    fine, thin = curves["fine"], curves["half across"]
    across, along, doubled = (distance(thin, other) for other in (
        fine, curves["half across, double along"], curves["half across, double step"]))
    entries = []
    for k, (name, (model, start)) in enumerate(MODELS.items()):
        mesh = np.add(windowed(across[k]), windowed(along[k]))
        step = np.array(windowed(doubled[k]))
        entries.append({
            "id": name, "model": model, "start": start,
            "uncertainty": {"mesh": upwards(mesh), "step": upwards(step), "total": upwards(mesh + step)},
            "tip": fine[k].round(9).tolist(),
        })
    return entries


def generate():
    """The fixture."""
    sanity.demand()
    curves, again = (tips(COARSE, COARSE_SAMPLES, scale) for scale in (1.0, 3.0))
    entries = runs()
    error, rounding = {}, {}
    for entry, curve, other in zip(entries, curves, again):
        off = windowed(distance(curve, np.array(entry["tip"])[:len(curve)])[::COARSE_STRIDE], COARSE_STRIDE)
        error[entry["id"]] = upwards(np.add(off, entry["uncertainty"]["total"][:len(off)]))
        rounding[entry["id"]] = upwards(windowed(distance(curve, other)))
    return head() | {"runs": entries, "coarse": coarse(curves) | {"error": error, "rounding": rounding}}


def check():
    """The part of the fixture that `--check` derives: everything that does not need the fine curves."""
    sanity.demand()
    return head() | {"coarse": coarse(tips(COARSE, COARSE_SAMPLES))}


def differences(stored, fresh):
    """Differences in the part that `check` derives, except versions of the tools and digits that rounding explains.

    Also the windows in which the coarse curve is farther from the stored fine curve than its stated error.
    """
    tools = {"python", *TOOLS}
    kept = {tool: version for tool, version in stored.get("generator", {}).items() if tool in tools}
    fresh = fresh | {"generator": fresh["generator"] | kept}
    if not {"runs", "coarse"} <= stored.keys() or [run["id"] for run in stored["runs"]] != list(MODELS):
        return [f"runs, coarse: must be there, runs for {', '.join(MODELS)}"]
    runs, quick = stored["runs"], stored["coarse"]
    allowed = {name: ROUNDING_FACTOR * max(rounding) + STORED for name, rounding in quick["rounding"].items()}
    same = {key: value for key, value in quick.items() if key not in ("error", "rounding")}
    same["tip"] = fixture.settled(same["tip"], fresh["coarse"]["tip"], allowed)
    rest = {key: value for key, value in stored.items() if key != "runs"} | {"coarse": same}
    faults = fixture.differences(rest, fresh)
    return faults + [fault for run in runs for fault in too_far(run, quick, fresh["coarse"])]


def too_far(run, stored, fresh):
    """Windows in which the coarse curve, as derived now, is farther from the fine curve than stated."""
    name = run["id"]
    tip = np.array(fresh["tip"][name])
    fine = np.array(run["tip"])[::COARSE_STRIDE][:len(tip)]
    found = windowed(distance(tip, fine), COARSE_STRIDE)
    return [f".runs[{name}]: {off:.1e} m from the coarse curve before {end} s, whose stated error is {error} m"
            for off, error, (_, end) in zip(found, stored["error"][name], WINDOWS) if off > error]
