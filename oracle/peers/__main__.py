"""`python -m oracle.peers [--out FILE] [--scene NAME ...] [--quick] [--repeats N] [--check]`: Exudyn on our scenes."""

import argparse
import sys
from pathlib import Path

SLOW = 1.0  # s: a longer run is repeated only FEWEST times
FEWEST = 3
MISSING = "Exudyn is not installed: pip install -r oracle/peers/requirements.txt; nothing was measured"


def measure(scene, options, interval, repeats):
    """One row: a warm-up run, then the timed runs. A failure of any run makes the row a failure."""
    from .solver import Failed, solve
    from .table import row

    results = []
    try:
        first = solve(scene, options, interval)
        for _ in range(repeats if first.seconds < SLOW else min(repeats, FEWEST)):
            results.append(solve(scene, options, interval))
    except Failed as failure:
        return row(scene, options, results, str(failure))
    return row(scene, options, results)


def main():
    """Command line; exit code 1 when a check fails, 0 also where Exudyn is not installed."""
    parser = argparse.ArgumentParser(prog="python -m oracle.peers", description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("out/peers.csv"),
                        help="the table; its provenance is written next to it as .json")
    parser.add_argument("--scene", nargs="+", metavar="NAME", help="only these scenes")
    parser.add_argument("--quick", action="store_true", help="the best points of two scenes, less than a minute")
    parser.add_argument("--repeats", type=int, default=5, help="timed runs per point, for runs shorter than a second")
    parser.add_argument("--check", action="store_true", help="compare with our own element and measure nothing")
    arguments = parser.parse_args()
    try:
        from . import program
    except ImportError as error:
        if error.name and error.name.split(".")[0] not in ("exudyn", "numpy"):
            raise
        print(MISSING)
        return 0
    if arguments.check:
        from .check import check

        return 0 if check() else 1

    from . import grid, scene, table

    names = arguments.scene or (grid.QUICK_SCENES if arguments.quick else list(grid.SCENES))
    if unknown := set(names) - set(grid.SCENES):
        parser.error(f"no grid for {', '.join(sorted(unknown))}; known scenes: {', '.join(grid.SCENES)}")
    if arguments.repeats < 1:
        parser.error("--repeats must be at least 1")
    print(f"Exudyn {program.VERSION}, {'fast' if program.IS_FAST else 'safe'} build", flush=True)
    rows = []
    for name in names:
        found = scene.read(name)
        for options in grid.points(name, arguments.quick):
            rows.append(measure(found, options, grid.SCENES[name].interval, arguments.repeats))
            line = rows[-1]
            took = f"{float(line['time_median_s']):9.4f} s" if line["status"] == "ok" else "failed: " + line["reason"]
            print(f"{name:20} {options.method:18} {options.elements:3} elements {options.steps:7} steps  {took}",
                  flush=True)
    table.write(arguments.out, rows, {
        "scenes": list(names), "quick": arguments.quick, "repeats": arguments.repeats})
    print(f"{len(rows)} rows, {sum(line['status'] == 'failed' for line in rows)} of them failed runs: {arguments.out}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
