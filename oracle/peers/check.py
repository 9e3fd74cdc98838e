"""Exudyn's element against the Euler-Bernoulli runs of `fixtures/pendulum.json`: the theory is the same.

The meshes are equal, so that only the error of the step remains. At half the step, the error of a method of order p is
about the change made by halving, divided by 2^p - 1. Twice this bounds the distance. The bound itself must be small.
"""

import json
from dataclasses import replace
from pathlib import Path

from .options import REDUCED_INTEGRATION, Options
from .scene import read
from .solver import distance, solve

FIXTURE = Path(__file__).resolve().parents[2] / "fixtures" / "pendulum.json"
ORDER = {"rk44": 4, "velocity-verlet": 2, "generalized-alpha": 2, "trapezoidal": 2}
ROUNDING = 2e-11  # m: rounding over the steps of a run, and error of the fixture
USEFUL = 3e-5  # m: a larger bound would miss errors

# Scene, run of the fixture, method, steps of the coarser solve over 0 - 0.5 s.
CASES = (
    ("pendulum-flexible", "flexible-eb-1", "rk44", 2000),
    ("pendulum-flexible", "flexible-eb-2", "rk44", 2000),
    ("pendulum-flexible", "flexible-eb-4", "rk44", 4000),
    ("pendulum-flexible", "flexible-eb-4", "velocity-verlet", 8000),
    ("pendulum-flexible", "flexible-eb-4", "generalized-alpha", 8000),
    ("pendulum-flexible", "flexible-eb-4", "trapezoidal", 8000),
    ("pendulum-2d-relaxed", "1d-eb-relaxed-2", "rk44", 2000),
    ("pendulum-2d-relaxed", "1d-eb-relaxed-4", "rk44", 4000),
    ("pendulum-2d", "1d-eb-sudden-2", "rk44", 16000),
    ("pendulum-2d", "1d-eb-sudden-4", "rk44", 32000),
    ("pendulum-2d", "1d-eb-sudden-2", "generalized-alpha", 64000),
)


def expected(name):
    """Elements, sample interval, end and tip positions of a run of the fixture."""
    with open(FIXTURE, encoding="utf-8") as file:
        run = next(run for run in json.load(file)["runs"] if run["id"] == name)
    return run["elements"], run["t"][1], run["t"][-1], run["tip"][1:]


def tip(scene, options, interval, end):
    """Positions of the tip in one solve."""
    found = solve(scene, options, interval, end)
    return list(zip(found.x, found.y))


def agree():
    """Prints distance and bound of each case; returns the number of cases that fail."""
    faults = 0
    for name, run, method, steps in CASES:
        elements, interval, end, ours = expected(run)
        options = Options(method, elements, steps, newton_tolerance=1e-10)
        coarse, fine = (tip(read(name), o, interval, end) for o in (options, replace(options, steps=2 * steps)))
        bound = 2 * distance(coarse, fine) / (2 ** ORDER[method] - 1) + ROUNDING
        found = distance(fine, ours)
        holds = found <= bound <= USEFUL
        faults += not holds
        print(f"{'agrees ' if holds else 'DIFFERS'}  {run:16} {method:18} {2 * steps:6} steps: "
              f"{found:.1e} m from ours, bound {bound:.1e}", flush=True)
    return faults


def can_fail():
    """Runs with an error in the peer's model, each of which must exceed the bounds; returns the number of unnoticed ones."""
    elements, interval, end, ours = expected("1d-eb-sudden-4")
    options, scene = Options("rk44", elements, 32000), read("pendulum-2d")
    faults = 0
    for what, wrong, changed in (
        ("heat of the opposite sign", replace(scene, expansion=-scene.expansion), options),
        ("reduced integration", scene, replace(options, integration=REDUCED_INTEGRATION)),
        ("explicit without the anchor", scene, replace(options, anchored=False)),
    ):
        found = distance(tip(wrong, changed, interval, end), ours)
        seen = found > 10 * USEFUL
        faults += not seen
        print(f"{'seen   ' if seen else 'UNSEEN '}  {what}: {found:.1e} m from ours", flush=True)
    return faults


def check():
    """Runs both checks; whether all cases hold."""
    return agree() + can_fail() == 0
