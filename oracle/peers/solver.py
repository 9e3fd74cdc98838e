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
    """Times of the solve call (s), counters of the solver, position of the probe at the times t, and its velocity if asked for."""

    seconds: float  # by the wall
    computed: float  # of the process, which others on the core do not lengthen
    newton_iterations: int
    jacobians: int
    t: list
    x: list
    y: list
    vx: list
    vy: list


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


def solve(scene, options, interval=None, end=None):
    """Builds the model, times the solve call and reads the probe at every multiple of `interval`, or its position and velocity at the
    start and after every step if there is none; raises `Failed`."""
    end = scene.end if end is None else end
    model = Model(scene, options, with_velocity=interval is None)
    every = end / options.steps if interval is None else interval
    chosen = settings(options, end, every)
    start, begun = time.perf_counter(), time.process_time()
    try:
        model.mbs.SolveDynamic(chosen, solverType=SOLVERS[options.method], showCausingItems=False)
    except Exception as error:
        raise Failed(why(error, model.mbs)) from error
    computed, seconds = time.process_time() - begun, time.perf_counter() - start
    stored = [model.mbs.GetSensorStoredData(sensor) for sensor in model.sensors]
    first = 1 if interval else 0  # the start only with every step
    rows = [data[data[:, 0] > (first - 0.5) * every] for data in stored]
    t = [k * every for k in range(first, round(end / every) + 1)]
    if any(len(data) != len(t) or abs(data[:, 0] - t).max() > 1e-9 for data in rows):
        raise Failed(f"{len(rows[0])} positions of the probe do not match the {len(t)} instants")
    x, y = (rows[0][:, i].tolist() for i in (1, 2))
    vx, vy = (rows[1][:, i].tolist() for i in (1, 2)) if interval is None else ([], [])
    reach = FAR * sum(map(scene.length, scene.rods))
    if not all(math.hypot(*place) < reach for place in zip(x, y)):  # also false for NaN
        raise Failed("the motion grew without bound, which Exudyn did not report")
    counts = model.mbs.sys["dynamicSolver"].it
    return Result(seconds, computed, counts.newtonStepsCount, counts.newtonJacobiCount, t, x, y, vx, vy)


def distance(positions, others):
    """The largest distance between two lists of points."""
    return max(math.dist(a, b) for a, b in zip(positions, others, strict=True))
