"""Options of one run: method, mesh, step, and choices of the peer's solver."""

from dataclasses import dataclass

EXPLICIT = ("velocity-verlet", "rk44")
IMPLICIT = ("generalized-alpha", "trapezoidal")

# Elements of a rod: Euler-Bernoulli's theory; Reissner's, with shear, three nodes to an element.
CABLE, BEAM = "ANCFCable2D", "BeamGeometricallyExact2D"

# 0: Gauss rules of order 9 (five points) for the axial strain and 5 (three points) for bending, as in our element.
# 1: Exudyn's rules of orders 7 and 3, a different element.
FULL_INTEGRATION, REDUCED_INTEGRATION = 0, 1


@dataclass(frozen=True)
class Options:
    """One point of the grid; `newton_tolerance` and `modified_newton` have no effect in explicit methods."""

    method: str
    elements: int  # of each rod
    steps: int
    newton_tolerance: float = 1e-6
    modified_newton: bool = True
    linear_solver: str = "EigenSparse"
    integration: int = FULL_INTEGRATION
    anchored: bool = True  # see `model.ANCHOR`; False only in `check`
    element: str = CABLE

    @property
    def is_explicit(self):
        """Whether the method is explicit: it solves no equations in a step and has no multipliers."""
        return self.method in EXPLICIT
