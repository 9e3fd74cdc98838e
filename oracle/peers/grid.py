"""Runs of each scene: the fastest at some error, with their coarser and finer neighbours.

A first search made about a thousand runs of every scene. These settings were never the fastest and are left out:

* the exact Newton method (modified is Exudyn's default): 2 to 4 times slower at equal steps; kept where the modified one
  begins to fail;
* a Newton tolerance of 1e-8 (Exudyn's default) or less: slower, no more accurate; 1e-4 is enough for the pendulums
  down to 1e-5 m, 1e-3 for the coarsest;
* a dense linear solver from 6 elements on (implicit) or from 8 (explicit);
* revolute joints in place of coordinate constraints, loads in proportion to the mass in place of nodal forces, the
  index-2 form of the constraints, reusing the sparse pattern or not, and other thresholds for a new Jacobian: within
  15 % either way;
* Runge-Kutta methods (fixed steps, or DOPRI5 with its own): the longest stable step is barely longer than that of
  velocity Verlet, which is as accurate as the mesh at a third of the cost. RK44 is kept for one mesh.

Fastest: generalized-alpha with the sparse solver and a tolerance of 1e-4 or 1e-5, except where the sudden heat's
axial waves have to be followed (below 5e-3 m): there velocity Verlet. Its steps here are near the longest stable one,
2000 times the elements over 2 s, and shorter beyond 32 elements. The trapezoidal rule comes close to generalized-alpha
in the pendulums and fails earlier in the scissors. Explicit methods need the pendulums' hinge anchored
(`model.ANCHOR`) and have no form for the pins between the rods of the scissors.
"""

from dataclasses import dataclass

from .options import BEAM, Options

# Number of a pendulum's elements below which the dense solver is faster.
SPARSE_FROM = {"implicit": 6, "explicit": 8}
SYMMETRIC = "EigenSparseSymmetric"  # the explicit methods solve with the mass matrix alone


@dataclass(frozen=True)
class Grid:
    """Time between rows of a timed run (s) and points of one scene; `quick` is a subset for short runs."""

    interval: float
    points: tuple
    quick: tuple = ()


def implicit(tolerance, *meshes, method="generalized-alpha", sparse_from=0, **others):
    """Points of an implicit method and a tolerance, from pairs of elements and steps."""
    solvers = ("EXUdense", "EigenSparse")
    return tuple(
        Options(method, elements, steps, tolerance, linear_solver=solvers[elements >= sparse_from], **others)
        for elements, steps in meshes)


def pendulum(tolerance, *meshes, **others):
    """Points of an implicit method for a pendulum, with the dense solver for few elements."""
    return implicit(tolerance, *meshes, sparse_from=SPARSE_FROM["implicit"], **others)


def explicit(*meshes, method="velocity-verlet"):
    """Points of an explicit method, from pairs of elements and steps."""
    solvers = ("EXUdense", SYMMETRIC)
    return tuple(Options(method, elements, steps, linear_solver=solvers[elements >= SPARSE_FROM["explicit"]])
                 for elements, steps in meshes)


SMOOTH_QUICK = (
    pendulum(1e-3, (1, 240), (3, 160), (3, 240), (4, 320))
    + pendulum(1e-4, (2, 200), (4, 400), (6, 800), (8, 1600), (12, 2400), (12, 3200), (16, 4800))
    + pendulum(1e-5, (16, 4800))
    + explicit((8, 16000), (24, 48000))
)
SMOOTH = SMOOTH_QUICK + (
    pendulum(1e-4, (1, 200), (3, 200), (3, 400), (4, 800), (6, 480), (6, 1600), (8, 800), (12, 1600), (16, 1600),
             (16, 3200), (24, 4800))
    + pendulum(1e-6, (2, 400), (4, 800), (8, 1600), (8, 3200), (16, 3200), (24, 6400))
    + pendulum(1e-5, (24, 12800), (32, 12800))
    + pendulum(1e-4, (4, 400), (8, 1600), (12, 3200), method="trapezoidal")
    + explicit((1, 2000), (2, 4000), (3, 6000), (4, 8000), (6, 13440), (12, 24000), (16, 32000), (32, 64000))
    + explicit((8, 11312), method="rk44")
)
# The finest runs within a few seconds; 64 elements bring no gain.
FINEST = pendulum(1e-5, (32, 25600), (64, 12800))

SUDDEN = (
    pendulum(1e-4, (1, 200), (2, 400), (3, 800), (4, 800), (6, 800), (8, 1600), (8, 3200), (12, 3200), (16, 3200),
             (16, 4800), (24, 3200), (24, 4800), (24, 9600), (32, 9600))
    + pendulum(1e-6, (3, 800), (6, 800), (8, 1600), (16, 4800))
    + pendulum(1e-4, (8, 1600), (16, 4800), method="trapezoidal")
    + explicit((1, 2000), (2, 4000), (3, 6000), (4, 8000), (6, 12000), (8, 16000), (12, 24000), (16, 32000),
               (24, 48000), (32, 64000))
    + explicit((8, 11312), method="rk44")
)

SCISSORS_QUICK = (
    implicit(1e-4, (2, 300), (2, 600), (2, 900), (2, 1200), (4, 1800), (4, 3600), (4, 6000))
    + implicit(1e-5, (4, 3600))
    + implicit(1e-6, (4, 3600))
)
SCISSORS = SCISSORS_QUICK + (
    implicit(1e-4, (2, 150), (2, 240), (2, 450), (4, 600), (4, 1200), (4, 2400), (6, 2400))
    + implicit(1e-4, (2, 240), (2, 300), modified_newton=False)
    + implicit(1e-6, (2, 300), (2, 600), (2, 1200), (4, 1800), (8, 3600))
    + implicit(1e-5, (2, 2400), (8, 6000), (8, 12000), (12, 12000), (16, 3000))
    + implicit(1e-6, (2, 600), (4, 1200), (4, 3600), (8, 6000), method="trapezoidal")
)
SCISSORS_HEATED = (
    implicit(1e-4, (2, 300), (2, 600), (2, 1200), (4, 1200), (4, 2400), (4, 3600), (4, 6000))
    + implicit(1e-6, (2, 600), (4, 3600))
    + implicit(1e-5, (8, 3600), (8, 12000))
)

# The beam with shear: fewer elements, as its order is four. Sparse matrices from 3 elements (21 unknowns) on.
BEAM_QUICK = implicit(1e-4, (2, 160), (2, 240), (3, 160), (3, 240), (3, 320), (4, 320), (4, 480), (6, 480), (6, 800), (8, 800),
                      element=BEAM, sparse_from=3)
BEAMS = BEAM_QUICK + implicit(1e-4, (1, 160), (3, 480), (4, 800), (6, 1200), (8, 1600), (8, 2400), (12, 1600), (12, 2400),
                              (12, 3200), element=BEAM, sparse_from=3) + implicit(
    1e-3, (2, 160), (3, 160), (4, 240), (6, 480), element=BEAM, sparse_from=3)
SCISSORS_BEAMS = implicit(1e-4, (1, 150), (1, 240), (1, 300), (1, 600), (1, 900), (1, 1200), (2, 600), (2, 900), (2, 1200), (2, 1800),
                          (2, 2400), (2, 3600), (4, 3600), element=BEAM) + implicit(
    1e-5, (1, 600), (1, 1200), (2, 1200), (2, 2400), (2, 3600), (2, 6000), (4, 6000), element=BEAM)

SCENES = {
    "pendulum-flexible": Grid(0.25, SMOOTH + FINEST + BEAMS, SMOOTH_QUICK + BEAM_QUICK),
    "pendulum-2d": Grid(0.25, SUDDEN),
    "pendulum-2d-relaxed": Grid(0.25, SMOOTH),
    "scissors-3": Grid(0.5, SCISSORS + SCISSORS_BEAMS, SCISSORS_QUICK + SCISSORS_BEAMS),
    "scissors-3-thermal": Grid(0.5, SCISSORS_HEATED),
}


def points(name, quick=False):
    """Options of one scene. `quick`: its subset, or every third point of a scene without one."""
    grid = SCENES[name]
    return (grid.quick or grid.points[::3]) if quick else grid.points
