"""Runs `ancf conform --trajectory` on motions of `motion.cpp`, right ones and ones with a mistake, and counts what it recognises."""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from motions import MISTAKES, RIGHT

HERE = Path(__file__).resolve().parent
FIXTURES = HERE.parents[2] / "fixtures"


def build(folder):
    """Compiles the program."""
    program = folder / "motion"
    subprocess.run(["g++", "-std=c++17", "-O2", "-o", program, HERE / "motion.cpp"], check=True)
    return program


# --------------------------------------------------------------------------------------- scenes, as the program reads them


def words(history):
    """A history as the number of its entries and the entries."""
    return [len(history), *(number for entry in history for number in entry)]


def pendulum(run, parameters):
    """Lines of the rod of Table 1 on its hinge."""
    p = parameters
    heat = [] if run["model"] == "none" else [[0.0, p["dT"]]]
    relaxed = int(run["start"] == "relaxed")
    return [
        ["rod", 0, 0, p["L"], 0, run["elements"], p["E"], p["nu"], p["rho"], p["alpha"], p["h"], p["w"], run["model"], relaxed,
         *words(heat)],
        ["fix", 0, "first", "x"],
        ["fix", 0, "first", "y"],
        ["gravity", 0, -p["g"]],
        ["point", "tip", 0, "last"],
        ["time", 0.5, 0.05],
    ]


def structure(scene):
    """Lines of a scene of structure.json."""
    lines, places = [], {}
    for n, rod in enumerate(scene["rods"]):
        material, section = rod.get("material", scene["material"]), rod.get("section", scene["section"])
        heat = rod.get("temperature", scene["temperature"])
        lines.append(["rod", *scene["points"][rod["from"]], *scene["points"][rod["to"]], rod["elements"],
                      *(material[key] for key in ("E", "nu", "rho", "alpha")), section["height"], section["width"],
                      heat["model"], 0, *words(heat["history"])])
        for key, place in (("from", "first"), ("to", "last"), ("pivot", "middle")):
            if key in rod:
                places.setdefault(rod[key], []).append((n, place))
    for meeting in places.values():
        lines += [["pin", *one, *two] for one, two in zip(meeting, meeting[1:])]
    for support in scene["supports"]:
        at = places[support["point"]][0]
        lines += [["fix", *at, axis] for axis in support.get("fix", [])]
        if "slide" in support:
            lines.append(["slide", *at, *support["slide"]])
        if "clamp" in support:
            lines.append(["clamp", [rod["name"] for rod in scene["rods"]].index(support["clamp"])])
    lines += [["force", *places[force["point"]][0], *force["force"], *words(force["history"])] for force in scene["forces"]]
    lines.append(["gravity", *scene["gravity"]])
    lines += [["point", name, *meeting[0]] for name, meeting in places.items()]
    return [*lines, ["time", scene["time"]["end"], scene["output"]["interval"]]]


def scenes():
    """Text of each scene of the fixtures, by name."""
    pendulums = json.loads((FIXTURES / "pendulum.json").read_text())
    # The program knows no heat across the rod alone.
    known = (run for run in pendulums["runs"] if run["element"] == "ancf" and run["model"] != "transverse")
    out = {run["id"]: pendulum(run, pendulums["parameters"]) for run in known}
    for motion in json.loads((FIXTURES / "structure.json").read_text())["trajectories"]:
        out[motion["id"]] = structure(motion["scene"])
    return {name: "".join(" ".join(map(str, line)) + "\n" for line in lines) for name, lines in out.items()}


# ------------------------------------------------------------------------------------------------------------ asking the kit


def examine(ancf, program, texts, case):
    """Report of the kit on a case, and the seconds it took; its `verdict` is `exploded` where the program gave no motion."""
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for n, step in enumerate(case.steps):
            options = ["--method", case.method, "--step", repr(step), "--print", case.prints]
            for name in case.made:
                options += ["--mistake", name]
            done = subprocess.run([program, *options], input=texts[case.scene], capture_output=True, text=True, check=False)
            if done.returncode:
                return {"verdict": "exploded", "summary": done.stderr, "mistakes": []}, 0.0
            files.append(Path(folder) / f"{n}.csv")
            files[-1].write_text(done.stdout)
        start = time.perf_counter()
        command = [ancf, "conform", "--trajectory", *files, "--scene", case.scene, "--out", Path(folder) / "out"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=580, check=False)
        report = Path(folder) / "out" / "conformance.json"
        if not report.exists():
            return {"verdict": "no report", "summary": done.stderr, "mistakes": []}, 0.0
        return json.loads(report.read_text()), time.perf_counter() - start


def judged(case, report):
    """What the report comes to: of a right motion `right` or `accused`, of a mistake `named`, `seen`, `undecided` or `called right`."""
    passes = report["verdict"] in ("agrees", "shorten_the_step")
    if not case.made and not case.wrong:
        return "right" if passes else "accused" if report["verdict"] == "mistake" else report["verdict"]
    if passes:
        return "called right"
    named = [mistake["what"] for mistake in report["mistakes"]]
    if any(part in what for what in named for part in case.named):
        return "named"
    return "seen" if report["verdict"] == "mistake" else report["verdict"]


def main():
    """Command line; exit code 1 where a bar is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--ancf", default="ancf", help="the program to ask")
    parser.add_argument("--set", choices=("right", "mistakes"), action="append", help="these only; without it, both")
    parser.add_argument("--only", action="append", default=[], help="cases whose name has this in it")
    parser.add_argument("--workers", type=int, default=2, help="cases at a time")
    parser.add_argument("--details", action="store_true", help="the report's first words for every case")
    arguments = parser.parse_args()
    sets = {"right": RIGHT, "mistakes": MISTAKES}
    cases = [case for name in arguments.set or sets for case in sets[name]
             if not arguments.only or any(part in case.name for part in arguments.only)]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(arguments.workers) as pool:
        program, texts = build(Path(folder)), scenes()
        counts = {"right": Counter(), "mistakes": Counter()}
        for case, (report, seconds) in zip(cases, pool.map(lambda one: examine(arguments.ancf, program, texts, one), cases)):
            result = judged(case, report)
            counts["mistakes" if case.made or case.wrong else "right"][result] += 1
            print(f"{result:13} {seconds:5.1f} s  {case.name}", flush=True)
            if arguments.details or result not in ("right", "named"):
                print(f"              {report['summary']}")
                for mistake in report["mistakes"]:
                    print(f"              - {mistake['what']} ({mistake['distance']:.1e} m)")
    for name, count in counts.items():
        if count:
            print(f"{name}: {sum(count.values())}; " + ", ".join(f"{number} {word}" for word, number in count.most_common()))
    wrong, right = counts["mistakes"], counts["right"]
    missed = 5 * wrong["named"] < 4 * sum(wrong.values()) or wrong["called right"] or right["right"] != sum(right.values())
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
