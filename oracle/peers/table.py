"""Results as a CSV table with their provenance as JSON. Files appear whole or not at all."""

import csv
import datetime
import io
import json
import os
import platform
import statistics
from pathlib import Path

from .program import IS_FAST, VERSION
from .solver import SPECTRAL_RADIUS

COLUMNS = ("scene,program,version,element,method,elements,step,newton_tolerance,modified_newton,linear_solver,status,"
           "reason,runs,time_median_s,time_min_s,time_max_s,steps,newton_iterations,jacobians,probe,t,x,y").split(",")


def numbers(values):
    """A list in one field with all digits."""
    return " ".join(map(repr, values))


def row(scene, options, results, reason=""):
    """One line of the table from the results of equal runs, or from a failure and its reason."""
    line = dict.fromkeys(COLUMNS, "") | {
        "scene": scene.name, "program": "Exudyn", "version": VERSION, "element": "ANCFCable2D",
        "method": options.method, "elements": options.elements, "step": repr(scene.end / options.steps),
        "linear_solver": options.linear_solver, "status": "failed" if reason else "ok", "reason": reason,
        "runs": len(results), "steps": options.steps, "probe": scene.probe,
    }
    if not options.is_explicit:
        line |= {"newton_tolerance": repr(options.newton_tolerance),
                 "modified_newton": str(options.modified_newton).lower()}
    if results and not reason:
        seconds, last = [result.seconds for result in results], results[-1]
        line |= {
            "time_median_s": repr(statistics.median(seconds)), "time_min_s": repr(min(seconds)),
            "time_max_s": repr(max(seconds)), "newton_iterations": last.newton_iterations,
            "jacobians": last.jacobians, "t": numbers(last.t), "x": numbers(last.x), "y": numbers(last.y),
        }
    return line


def processor():
    """Model of the processor, if the system reports it."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
        return next(line.split(":", 1)[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or "unknown"


def provenance(arguments):
    """Provenance of the times: program, build, settings, machine, load, date."""
    return {
        "program": "Exudyn",
        "version": VERSION,
        "build": "exudynCPPfast (no range checks)" if IS_FAST else "exudynCPP (with range checks)",
        "timed": "the call of SolveDynamic alone, wall clock, after one run that is not counted; models are built anew",
        "settings": {
            "threads": 1, "adaptiveStep": False, "automaticStepSize": False, "files": False,
            "spectralRadius (generalized-alpha)": SPECTRAL_RADIUS,
            "reuseAnalyzedPattern": True, "everything else": "Exudyn's defaults",
        },
        "command": arguments,
        "python": platform.python_version(),
        "platform": platform.platform(),
        "processor": processor(),
        "processors": os.cpu_count(),
        "load_average_at_end": os.getloadavg() if hasattr(os, "getloadavg") else None,
        "date": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
    }


def replace_file(path, text):
    """Replaces a file by writing a new one and renaming it."""
    part = path.with_name(path.name + ".part")
    part.write_text(text, encoding="utf-8", newline="")
    part.replace(path)


def write(path, rows, arguments):
    """Writes the rows to `path`, and their provenance to `path` with the suffix .json."""
    path.parent.mkdir(parents=True, exist_ok=True)
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    replace_file(path.with_suffix(".json"), json.dumps(provenance(arguments), indent=1) + "\n")
    replace_file(path, text.getvalue())
