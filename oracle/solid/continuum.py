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

# Tolerance of a check of the coarse curve: factor on the observed rounding, for another machine; and rounding of storage (m, J).
ROUNDING_FACTOR, STORED = 30, 1e-9

ENERGIES = ("kinetic", "strain", "potential")
ENERGY_SAMPLES = 50  # after t = 0: until 0.5 s, as the energies of the beams in pendulum.json

CONVENTIONS = {
    "units": "SI: m, s, kg, K, J",
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
    "energy": "kinetic; strain, as the integral of E (E_GL - E_T):(E_GL - E_T) / 2; potential, zero at the hinge's height; "
              "every `interval` from t = 0 until 0.5 s, J, at level fine. energy_uncertainty: that of each for the windows until "
              "then, found as `total` is for the tip. Wave fronts of sudden models are not resolved: their energies are the least certain",
    "coarse": "for a quick check: tip and energy at its own interval; error: largest distance from the fine curve, plus that "
              "curve's total, for each window that it reaches; rounding: largest distance from the same run in other "
              "units (lengths times 3, E times 9), which moves alike and rounds differently; energy_error and "
              "energy_rounding are the same of each energy",
    "edits": "never by hand: the command under generator writes this file, and with --check repeats its coarse level",
}


class Observed(NamedTuple):
    """The tip, (model, sample, component), and its energies, (model, sample, energy)."""

    tip: np.ndarray
    energy: np.ndarray


def observed(level, samples=SAMPLES, scale=1.0):
    """Tip and energies until ENERGY_SAMPLES, computed with all lengths multiplied by `scale`."""
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
    tip, energy = zip(*((r[:, solid.tip], solid.energies(r, v)) for r, v in states))
    # Energies are density times squared velocity times area.
    curves = Observed(np.array(tip).transpose(2, 0, 1) / scale, np.array(energy[:ENERGY_SAMPLES + 1]).transpose(2, 0, 1) / scale**4)
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


def by_energy(values):
    """A table by energy of arrays whose last index is the energy."""
    return dict(zip(ENERGIES, np.transpose(values)))


def energies(curve, stride=1):
    """Energies of one model as stored."""
    return {name: values.tolist() for name, values in by_energy(curve[::stride].round(9)).items()}


def coarse(curves):
    """The coarse level as stored."""
    return COARSE.described() | {
        "interval": COARSE_STRIDE * INTERVAL,
        "tip": dict(zip(MODELS, curves.tip[:, ::COARSE_STRIDE].round(9).tolist())),
        "energy": {name: energies(curve, COARSE_STRIDE) for name, curve in zip(MODELS, curves.energy)},
    }


def runs():
    """The fine curves with their uncertainties."""
    levels = {name: observed(level) for name, level in LEVELS.items()}
    fine, thin = levels["fine"], levels["half across"]
    others = (fine, levels["half across, double along"], levels["half across, double step"])
    across, along, doubled = (distance(thin.tip, other.tip) for other in others)
    apart = sum(abs(thin.energy - other.energy) for other in others)
    entries = []
    for k, (name, (model, start)) in enumerate(MODELS.items()):
        mesh = np.add(windowed(across[k]), windowed(along[k]))
        step = np.array(windowed(doubled[k]))
        entries.append({
            "id": name, "model": model, "start": start,
            "uncertainty": {"mesh": upwards(mesh), "step": upwards(step), "total": upwards(mesh + step)},
            "tip": fine.tip[k].round(9).tolist(),
            "energy": energies(fine.energy[k]),
            "energy_uncertainty": {name: upwards(windowed(off)) for name, off in by_energy(apart[k]).items()},
        })
    return entries


def generate():
    """The fixture."""
    sanity.demand()
    curves, again = (observed(COARSE, COARSE_SAMPLES, scale) for scale in (1.0, 3.0))
    entries = runs()
    error, rounding, energy_error, energy_rounding = {}, {}, {}, {}
    for k, entry in enumerate(entries):
        name = entry["id"]
        off = distance(curves.tip[k], np.array(entry["tip"])[:len(curves.tip[k])])
        off = windowed(off[::COARSE_STRIDE], COARSE_STRIDE)
        error[name] = upwards(np.add(off, entry["uncertainty"]["total"][:len(off)]))
        rounding[name] = upwards(windowed(distance(curves.tip[k], again.tip[k])))
        fine = np.transpose([entry["energy"][energy] for energy in ENERGIES])
        off = by_energy(abs(curves.energy[k] - fine)[::COARSE_STRIDE])
        energy_error[name] = {
            energy: upwards(np.add(windowed(values, COARSE_STRIDE), entry["energy_uncertainty"][energy]))
            for energy, values in off.items()}
        apart = by_energy(abs(curves.energy[k] - again.energy[k]))
        energy_rounding[name] = {energy: upwards(windowed(values)) for energy, values in apart.items()}
    bounds = {"error": error, "rounding": rounding, "energy_error": energy_error, "energy_rounding": energy_rounding}
    return head() | {"runs": entries, "coarse": coarse(curves) | bounds}


def check():
    """The part of the fixture that `--check` derives: everything that does not need the fine curves."""
    sanity.demand()
    return head() | {"coarse": coarse(observed(COARSE, COARSE_SAMPLES))}


def keep(stored, fresh):
    """The fresh document with the stored tips and their uncertainties wherever rounding explains the difference."""
    if [run["id"] for run in stored["runs"]] != list(MODELS):
        return fresh
    allowed = allowances(fresh["coarse"]["rounding"])
    runs = []
    for old, new in zip(stored["runs"], fresh["runs"]):
        tip = fixture.settled(new["tip"], old["tip"], allowed[new["id"]])
        same = tip == old["tip"]
        runs.append(new | {"tip": tip} | ({"uncertainty": old["uncertainty"]} if same else {}))
    quick, old = fresh["coarse"], stored["coarse"]
    tips = fixture.settled(quick["tip"], old["tip"], allowed)
    bounds = {name: old[name] for name in ("error", "rounding")} if tips == old["tip"] else {}
    return fresh | {"runs": runs, "coarse": quick | {"tip": tips} | bounds}


def allowances(rounding):
    """What two machines may differ by, from the observed rounding by model (and energy)."""
    if isinstance(rounding, dict):
        return {name: allowances(windows) for name, windows in rounding.items()}
    return ROUNDING_FACTOR * max(rounding) + STORED


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
    bounds = ("error", "rounding", "energy_error", "energy_rounding")
    same = {key: value for key, value in quick.items() if key not in bounds}
    for key, rounding in (("tip", "rounding"), ("energy", "energy_rounding")):
        same[key] = fixture.settled(same[key], fresh["coarse"][key], allowances(quick[rounding]))
    rest = {key: value for key, value in stored.items() if key != "runs"} | {"coarse": same}
    faults = fixture.differences(rest, fresh)
    return faults + [fault for run in runs for fault in too_far(run, quick, fresh["coarse"])]


def too_far(run, stored, fresh):
    """Windows in which the coarse curves, as derived now, are farther from the fine ones than stated."""
    name = run["id"]
    tip = np.array(fresh["tip"][name])
    fine = np.array(run["tip"])[::COARSE_STRIDE][:len(tip)]
    compared = [("m", windowed(distance(tip, fine), COARSE_STRIDE), stored["error"][name])]
    for energy, values in fresh["energy"][name].items():
        fine = np.array(run["energy"][energy])[::COARSE_STRIDE][:len(values)]
        found = windowed(abs(np.array(values) - fine), COARSE_STRIDE)
        compared.append((f"J ({energy})", found, stored["energy_error"][name][energy]))
    return [f".runs[{name}]: {off:.1e} {unit} from the coarse curve before {end} s, whose stated error is {error}"
            for unit, found, errors in compared for off, error, (_, end) in zip(found, errors, WINDOWS) if off > error]
