"""Motions that `motion.py` asks about: right ones by several methods, and ones with a mistake, with what has to be named."""

from typing import NamedTuple


class Motion(NamedTuple):
    """A scene of the fixtures moved by a method with one step or two.

    `made` are mistakes of the program, `wrong` says that the method itself is the mistake. `named` are words of which one has to stand
    in the name of a mistake in the report.
    """

    scene: str
    method: str
    steps: tuple
    made: tuple = ()
    named: tuple = ()
    prints: str = "positions"
    wrong: bool = False

    @property
    def name(self):
        """Scene, method, steps, mistakes."""
        steps = ", ".join(f"{step:g}" for step in self.steps)
        return " ".join((self.scene, self.method, f"({steps})", self.prints, *self.made))


RIGHT = [
    Motion("flexible-2", "verlet", (5e-5,)),
    Motion("flexible-2", "rk4", (5e-5,), prints="all"),
    Motion("flexible-2", "newmark", (5e-4, 2.5e-4), prints="all"),
    Motion("flexible-2", "newmark", (2.5e-3,)),
    Motion("flexible-4", "generalized-alpha", (1e-3, 5e-4)),
    Motion("flexible-1", "generalized-alpha", (2.5e-4,), prints="velocities"),
    Motion("1d-sudden-2", "verlet", (5e-5,), prints="all"),
    Motion("1d-sudden-2", "generalized-alpha", (1e-4, 5e-5)),
    Motion("1d-sudden-2", "newmark", (1e-3,)),
    Motion("2d-sudden-2", "verlet", (5e-5,), prints="all"),
    Motion("2d-sudden-2", "verlet", (5e-5, 2.5e-5)),
    Motion("2d-sudden-2", "rk4", (2.5e-5,), prints="all"),
    Motion("2d-sudden-2", "newmark", (1e-4, 5e-5), prints="all"),
    Motion("2d-sudden-2", "newmark", (5e-4,)),
    Motion("2d-sudden-2", "generalized-alpha", (1e-4,), prints="all"),
    Motion("2d-sudden-2", "generalized-alpha", (5e-4, 2.5e-4)),
    Motion("2d-sudden-4", "verlet", (2.5e-5,)),
    Motion("2d-relaxed-2", "newmark", (1e-3, 5e-4), prints="all"),
    Motion("2d-relaxed-4", "rk4", (2.5e-5,)),
    Motion("knee-2-1", "verlet", (2.5e-5,), prints="all"),
    Motion("knee-2-1", "newmark", (5e-4, 2.5e-4), prints="all"),
    Motion("knee-2-1", "generalized-alpha", (1.25e-3,)),
    Motion("scissor-1-2", "verlet", (2.5e-5,)),
    Motion("scissor-1-2", "generalized-alpha", (5e-4, 2.5e-4), prints="velocities"),
]

MISTAKES = [
    # Constraints and assembly.
    Motion("flexible-2", "newmark", (2.5e-4,), ("hinge-clamped",), ("hinge is clamped", "section's vector is held at hinge")),
    Motion("flexible-2", "verlet", (5e-5,), ("hinge-one-sided",), ("hinge is held along y only",)),
    Motion("knee-2-1", "newmark", (2.5e-4,), ("clamp-lost",), ("p is hinged in place of clamped",)),
    Motion("knee-2-1", "verlet", (2.5e-5,), ("slide-across",), ("s slides across its direction",)),
    Motion("scissor-1-2", "verlet", (2.5e-5,), ("pin-one-sided",), ("rods at m are pinned along x only",)),
    Motion("flexible-2", "rk4", (5e-5,), ("mass-once",), ("mass assembled once", "assembled once")),
    Motion("flexible-4", "verlet", (5e-5,), ("element-lost",), ("elastic force of element 4 of 4 is left out",)),
    Motion("flexible-2", "verlet", (5e-5,), ("mass-lumped",), ("a diagonal mass",)),
    Motion("flexible-2", "generalized-alpha", (5e-4, 2.5e-4), ("mesh",), ("4 elements of the paper",)),
    # Loads.
    Motion("flexible-2", "verlet", (5e-5,), ("weight-lost",), ("the weight is lost",)),
    Motion("flexible-2", "newmark", (5e-4, 2.5e-4), ("weight-doubled",), ("the weight is twice", "the weight times 2")),
    Motion("flexible-4", "verlet", (5e-5,), ("weight-of-one-lost",), ("weight of element 2 of 4 is left out",)),
    Motion("2d-sudden-2", "verlet", (5e-5,), ("weight-up",), ("the weight acts upwards",)),
    Motion("scissor-1-2", "verlet", (2.5e-5,), ("force-constant",), ("the force at b does not follow its history",)),
    # Law.
    Motion("flexible-2", "generalized-alpha", (2.5e-4,), ("nu-0.3",), ("ν is 0.3",)),
    Motion("2d-sudden-2", "verlet", (5e-5,), ("nu-0.3",), ("ν is 0.3",)),
    Motion("knee-2-1", "generalized-alpha", (2.5e-4,), ("nu-lost",), ("ν is 0", "no coupling by ν")),
    Motion("flexible-2", "verlet", (5e-5,), ("shear-once",), ("the shear counted once",)),
    Motion("flexible-2", "verlet", (5e-5,), ("two-points",), ("2 × 3 Gauss points",)),
    # Heat, sudden.
    Motion("2d-sudden-2", "verlet", (5e-5,), ("heat-ramped",), ("the heat grows over 0.1",)),
    Motion("2d-sudden-2", "newmark", (1e-4, 5e-5), ("heat-ramped",), ("the heat grows over 0.1", "the heat grows over 0.09")),
    Motion("2d-sudden-2", "verlet", (5e-5,), ("heat-doubled",), ("the heat is doubled", "the thermal strain times 2.0")),
    Motion("1d-sudden-2", "generalized-alpha", (1e-4, 5e-5), ("heat-doubled",),
           ("the heat is doubled", "the thermal strain times 2.0", "the thermal strain times 1.99")),
    Motion("2d-sudden-2", "verlet", (5e-5,), ("1d-for-2d",), ("1D heat in place of 2D",)),
    Motion("2d-sudden-2", "newmark", (1e-4, 5e-5), ("1d-for-2d",), ("1D heat in place of 2D",), "all"),
    Motion("2d-sudden-2", "generalized-alpha", (1e-4,), ("1d-for-2d",), ("1D heat in place of 2D",), "all"),
    Motion("1d-sudden-2", "rk4", (2.5e-5,), ("2d-for-1d",), ("2D heat in place of 1D",)),
    Motion("2d-sudden-2", "verlet", (5e-5,), ("relaxed-for-sudden",), ("a relaxed start in place of a sudden one",)),
    Motion("2d-sudden-4", "newmark", (1e-4,), ("relaxed-for-sudden",), ("a relaxed start in place of a sudden one",), "all"),
    Motion("2d-sudden-2", "verlet", (5e-5,), ("heat-minus",), ("the heat has the wrong sign", "the thermal strain times -1.0")),
    # Heat with a history.
    Motion("knee-2-1", "newmark", (2.5e-4,), ("1d-for-2d",), ("1D heat in place of 2D",), "all"),
    Motion("knee-2-1", "verlet", (2.5e-5,), ("heat-doubled",), ("the heat is doubled", "the thermal strain times 2.0")),
    Motion("scissor-1-2", "verlet", (2.5e-5,), ("heat-of-the-other",), ("rod two has the heat of rod one",)),
    Motion("scissor-1-2", "generalized-alpha", (2.5e-4,), ("heat-lost",), ("there is no heat",)),
    # Methods.
    Motion("flexible-2", "newmark-damped", (1e-3, 5e-4), wrong=True, named=("first-order method",)),
    Motion("2d-sudden-2", "newmark-damped", (1e-4,), wrong=True, named=("first-order method",)),
    Motion("flexible-2", "euler-half-implicit", (5e-5, 2.5e-5), wrong=True, named=("first-order method",)),
    Motion("1d-sudden-2", "euler-implicit", (1e-4, 5e-5), wrong=True, named=("first-order method",)),
    Motion("knee-2-1", "euler-implicit", (2.5e-4,), wrong=True, named=("first-order method",)),
    Motion("flexible-2", "rk4", (5e-5,), ("rk4-last-weight",), ("times times 1.000",)),
    Motion("flexible-2", "verlet", (5e-5,), ("damped",), ("damping",)),
    # Others.
    Motion("flexible-2", "verlet", (5e-5,), ("hinge-spring",), ("fixed points give way",)),
    Motion("knee-2-1", "newmark", (2.5e-4,), ("load-late",), ("loads and heat are those of the step before",)),
    Motion("knee-2-1", "verlet", (2.5e-5,), ("welded",), ("rods at k are welded",)),
    Motion("scissor-1-2", "newmark", (2.5e-4,), ("material-of-first",), ("all rods have the scene's material",)),
    Motion("flexible-4", "rk4", (5e-5,), ("gravity-9.81",), ("g is 9.81",)),
    Motion("flexible-2", "generalized-alpha", (1e-3, 5e-4), ("density",), ("ρ times 1.10", "ρ times 1.09")),
    Motion("2d-sudden-2", "newmark", (1e-4,), ("heat-half-more",), ("the thermal strain times 1.5", "the thermal strain times 1.49")),
    Motion("1d-sudden-2", "verlet", (5e-5,), ("heat-quadratic",), ("the heat grows over",)),
    Motion("2d-relaxed-2", "newmark", (5e-4,), ("relaxed-for-sudden",), ("a sudden start in place of a relaxed one",)),
    Motion("2d-sudden-2", "generalized-alpha", (1e-4, 5e-5), ("1d-for-2d",), ("1D heat in place of 2D",)),
]
