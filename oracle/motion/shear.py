"""Effect of a shear correction factor of 5/6 on the tip of the flexible pendulum.

The paper's element has no such factor: its shear stress is uniform over the section, where that of a solid is a
parabola and does 6/5 of the work. In the rod's own axes, with nu = 0, the energy density is
E/2 (E_11^2 + E_22^2) + mu/2 (2 E_12)^2; the factor multiplies the last term. Rods with and without it are integrated
together by velocity Verlet. Their errors are nearly equal, so that the shift is known better than either motion.

`python -m oracle.motion.shear` takes some minutes. It prints the distances of the suddenly heated rod (2D), with and
without the factor, from the plane solid of fixtures/continuum.json.
"""

import numpy as np

from ..fixtures.fixture import read, settled
from .hinged_rod import TABLE_1, Plane
from .integrators import verlet

FACTOR = 5 / 6

# With 8 elements the error of the mesh is about half of the largest shift, with 4 all of it.
ELEMENTS = 16

# The highest frequency, 3.4e4 rad/s, allows steps below 5.9e-5 s. The mesh determines the accuracy.
STEP = 4e-5

INTERVALS = 40
INTERVAL = 0.05

# Elements and step: the stored run; half the elements; half the elements and half the step.
RUNS = [(ELEMENTS, STEP), (ELEMENTS // 2, STEP), (ELEMENTS // 2, STEP / 2)]

# Allowance for the rounding of another machine (m): about thirty times the effect of a disturbance of 1e-13 at the start.
ROUNDING = 1e-11


def shift(elements, step):
    """Tip with the factor minus tip without it, at all samples."""
    rods = Plane(elements, np.ones((2, 2)), shear=np.array([1.0, FACTOR]))
    q = np.repeat(Plane(elements, [1.0, 1.0]).straight(relaxed=False)[:, None], 2, 1)
    v = np.zeros_like(q)
    shifts = [[0.0, 0.0]]
    for _ in range(INTERVALS):
        a = rods.acceleration(0, q)
        change_q, change_v = verlet(rods.acceleration, 0, q, v, a, INTERVAL, round(INTERVAL / step))
        q, v = q + change_q, v + change_v
        tip = q[-4:-2]
        shifts.append(tip[:, 1] - tip[:, 0])
    return np.array(shifts)


def entry(stored, coarse, with_half_the_step):
    """The entry `shear` of the fixture, from the shifts of `RUNS`."""

    def largest(difference):
        return float(np.hypot(*difference.T).max())

    return {
        "description": "tip of the flexible pendulum, model none, element ancf, with the shear part of the strain "
        "energy times the factor, less the tip without; velocity Verlet, both rods in one array",
        "factor": FACTOR,
        "elements": ELEMENTS,
        "step": STEP,
        "t": [k / 20 for k in range(INTERVALS + 1)],
        "shift": stored.tolist(),
        "uncertainty": {
            "mesh": largest(stored - coarse),
            "step": largest(coarse - with_half_the_step),
            "how": f"m, largest distance over the samples. mesh: to the shift with {ELEMENTS // 2} elements. step: "
            f"of the shifts with {ELEMENTS // 2} elements and this step or half of it. Whole distances, not "
            "fractions",
        },
    }


def settled_entry(stored, fresh):
    """The stored entry with numbers replaced by the fresh ones where rounding explains the difference."""
    return settled(stored, fresh, {"shift": ROUNDING, "uncertainty": ROUNDING})


def print_sudden(elements=32, step=1.25e-5):
    """Prints the largest distances (m) of the suddenly heated rod from the solid in each window, without and with the factor."""
    solid = read("continuum.json")
    tips = np.array(next(run["tip"] for run in solid["runs"] if run["id"] == "2d-sudden"))
    square = 1 + 2 * TABLE_1["alpha"] * TABLE_1["dT"]
    rods = Plane(elements, np.full((2, 2), square), shear=np.array([1.0, FACTOR]))
    q = np.repeat(Plane(elements, [square, square]).straight(relaxed=False)[:, None], 2, 1)
    v = np.zeros_like(q)
    found = [np.zeros(2)]
    for tip in tips[1:]:
        a = rods.acceleration(0, q)
        change_q, change_v = verlet(rods.acceleration, 0, q, v, a, solid["interval"], round(solid["interval"] / step))
        q, v = q + change_q, v + change_v
        found.append(np.hypot(*(q[-4:-2] - tip[:, None])))
    for start, end in solid["windows"]:
        within = slice(round(start / solid["interval"]) + 1, round(end / solid["interval"]) + 1)
        without, corrected = np.max(found[within], axis=0)
        print(f"{start} ... {end} s: {without:.1e} m, with {FACTOR:.4f} {corrected:.1e} m")


if __name__ == "__main__":
    print_sudden()
