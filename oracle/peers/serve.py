"""Questions from a study of error against run time, answered in lines of JSON on standard input and output.

`{"points": SCENE, "quick": BOOL}`: the runs of a scene. `{"run": ID, "record": BOOL}`: makes one; with `record`, position and velocity after
every step. `{"limit": SCENE, "element": NAME, "times": [...]}`: what an element converges to, with its uncertainty.
"""

import contextlib
import json
import math
import sys
from dataclasses import replace

from . import grid, scene
from .options import CABLE, Options
from .program import IS_FAST, VERSION
from .solver import Failed, solve

# Elements and steps of the finest runs that show an element's limit; half of each shows how far it is.
FINEST = {"pendulum-flexible": (64, 32000), "scissors-3": (16, 24000)}
NEWTON = 1e-7


def describe(options, end):
    """One run in words and numbers."""
    return {
        "element": options.element, "method": options.method, "elements": options.elements, "step": end / options.steps,
        "newton_tolerance": None if options.is_explicit else options.newton_tolerance,
        "options": f"modified Newton {str(options.modified_newton).lower()}, {options.linear_solver}",
    }


def motion(found, options, times):
    """Positions at some times, all of them ends of steps."""
    interval = times[0]
    result = solve(found, options, interval)
    return [list(place) for place in zip(result.x, result.y)]


def limit(name, element, times):
    """The limit of an element: by half the step and half the elements, with the change by both."""
    if element == CABLE or name not in FINEST:
        return {"position": None}
    found = scene.read(name)
    elements, steps = FINEST[name]
    finest = Options("generalized-alpha", elements, steps, NEWTON, element=element)
    position, *others = (motion(found, options, times) for options in (
        finest, replace(finest, steps=steps // 2), replace(finest, elements=elements // 2)))
    changes = [max(math.dist(a, b) for a, b in zip(position, other)) for other in others]
    return {"position": position, "uncertainty": sum(changes)}


class Server:
    """The runs that were listed, by their number."""

    def __init__(self):
        self.runs = []

    def answer(self, question):
        """The answer to one question."""
        if "points" in question:
            name = question["points"]
            if name not in grid.SCENES:
                return {"points": []}
            found, first = scene.read(name), len(self.runs)
            points = grid.points(name, question.get("quick", False))
            self.runs += [(found, options, grid.SCENES[name].interval) for options in points]
            return {"points": [{"id": first + n} | describe(options, found.end) for n, options in enumerate(points)]}
        if "run" in question:
            found, options, interval = self.runs[question["run"]]
            record = question.get("record", False)
            try:
                result = solve(found, options, None if record else interval)
            except Failed as failure:
                return {"failed": str(failure)}
            motion = {"t": result.t, "x": result.x, "y": result.y, "vx": result.vx, "vy": result.vy} if record else {}
            return {"seconds": result.seconds, "computed": result.computed, "steps": options.steps,
                    "newton_iterations": result.newton_iterations, "jacobians": result.jacobians} | motion
        if "limit" in question:
            return limit(question["limit"], question["element"], question["times"])
        raise ValueError(f"no question of this kind: {sorted(question)}")


def serve():
    """Answers until the input ends. What the program prints goes to standard error."""
    out, server = sys.stdout, Server()
    with contextlib.redirect_stdout(sys.stderr):
        build = "fast build, without range checks" if IS_FAST else "build with range checks"
        print(json.dumps({"program": "Exudyn", "version": VERSION, "build": build}), file=out, flush=True)
        for line in sys.stdin:
            print(json.dumps(server.answer(json.loads(line))), file=out, flush=True)
