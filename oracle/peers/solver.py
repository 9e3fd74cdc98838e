"""One solve: settings, timed call, result."""

import math
import time
from dataclasses import dataclass

from .model import Model
from .program import exu

SOLVERS = {
    "generalized-alpha": exu.DynamicSolverType.GeneralizedAlpha,
    "trapezoidal": exu.DynamicSolverType.GeneralizedAlpha,  # with Newmark's beta = 1/4, gamma = 1/2
    "velocity-verlet": exu.DynamicSolverType.VelocityVerlet,
    "rk44": exu.DynamicSolverType.RK44,
}
SPECTRAL_RADIUS = 0.9
FAR = 1.5  # multiple of the total length of the rods; no point can be farther unless the step was too long


class Failed(Exception):
    """Reason why a run has no result."""


@dataclass(frozen=True)
class Result:
    """Time of the solve call (s), counters of the solver, position of the probe at the times t."""

    seconds: float
    newton_iterations: int
    jacobians: int
    t: list
    x: list
    y: list


def settings(options, end, interval):
    """Settings: fixed steps, one thread, no output; otherwise Exudyn's defaults."""
    chosen = exu.SimulationSettings()
    integration = chosen.timeIntegration
    integration.endTime = end
    integration.numberOfSteps = options.steps
    integration.adaptiveStep = False
    integration.automaticStepSize = False
    integration.verboseMode = 0
    integration.stepInformation = 0
    integration.generalizedAlpha.spectralRadius = SPECTRAL_RADIUS
    integration.generalizedAlpha.useNewmark = options.method == "trapezoidal"
    integration.newton.useModifiedNewton = options.modified_newton
    integration.newton.relativeTolerance = options.newton_tolerance
    chosen.linearSolver.solverType = getattr(exu.LinearSolverType, options.linear_solver)
    chosen.linearSolver.reuseAnalyzedPattern = True
    chosen.parallel.numberOfThreads = 1
    chosen.solution.file.write = False
    chosen.solution.sensors.writePeriod = interval
    chosen.show.globalTimers = False
    return chosen


def why(error, mbs):
    """Message for a solve that failed: Exudyn's own, with time, iterations and residual."""
    at = mbs.sys["dynamicSolver"]
    message = " ".join(str(error).split())[:120] or type(error).__name__
    where = f"t = {at.it.currentTime:.6g} s, {at.it.newtonSteps} iterations, residual {at.conv.residual:.3g}"
    return f"{message} at {where}"


def solve(scene, options, interval, end=None):
    """Builds the model, times the solve call and reads the probe at every multiple of `interval`; raises `Failed`."""
    end = scene.end if end is None else end
    model = Model(scene, options)
    chosen = settings(options, end, interval)
    start = time.perf_counter()
    try:
        model.mbs.SolveDynamic(chosen, solverType=SOLVERS[options.method], showCausingItems=False)
    except Exception as error:
        raise Failed(why(error, model.mbs)) from error
    seconds = time.perf_counter() - start
    rows = [row for row in model.mbs.GetSensorStoredData(model.sensor).tolist() if row[0] > interval / 2]
    t = [k * interval for k in range(1, round(end / interval) + 1)]
    if len(rows) != len(t) or any(abs(row[0] - at) > 1e-9 for row, at in zip(rows, t)):
        raise Failed(f"{len(rows)} positions of the probe do not match the {len(t)} sample times")
    x, y = ([row[i] for row in rows] for i in (1, 2))
    reach = FAR * sum(map(scene.length, scene.rods))
    if not all(math.hypot(*place) < reach for place in zip(x, y)):  # also false for NaN
        raise Failed("the motion grew without bound, which Exudyn did not report")
    counts = model.mbs.sys["dynamicSolver"].it
    return Result(seconds, counts.newtonStepsCount, counts.newtonJacobiCount, t, x, y)


def distance(positions, others):
    """The largest distance between two lists of points."""
    return max(math.dist(a, b) for a, b in zip(positions, others, strict=True))
