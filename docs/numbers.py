"""Numbers and pictures of the pages, from results of runs: nobody copies them by hand.

    python3 docs/numbers.py --take main out            # keeps the results of `ancf` that are in out/, with their pictures
    python3 docs/numbers.py --take stability out       # keeps those of `ancf stability`; `error-time` and `readings` likewise
    python3 docs/numbers.py --take evidence measured   # keeps what tests wrote into the file that ANCF_MEASURED named
    python3 docs/numbers.py                            # writes the blocks of the pages from docs/results/
    python3 docs/numbers.py --check [--run main out]   # compares the pages with docs/results/, and those with a new run

A block stands between `<!-- NAME:begin -->` and `<!-- NAME:end -->`, a number between `<!--=RESULT:NAME-->` and `<!--/-->`; the end of NAME may be
`.*`, all that begin so in a row, or `.~`, the least and the largest of them. Needs Python 3.11 and nothing else.
"""

import argparse
import json
import math
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

PAGES = Path(__file__).resolve().parent
ROOT = PAGES.parent
RESULTS = PAGES / "results"
COMMANDS = {
    "main": "cargo run --release",
    "readings": "cargo run --release -- readings",
    "stability": "cargo run --release -- stability",
    "evidence": "cargo test",
    "error-time": 'cargo run --release -- error-time --peer "peers/bin/python -m oracle.peers"',
}
# The main job reads this one.
READINGS = ROOT / "study" / "readings.json"
PICTURES = {"readings": (), "main": ("figure1.svg", "figure2.svg", "figure3.svg", "figure4.svg", "figure7.svg", "figure8-y.svg", "structure.svg", "deployment.svg"), "stability": ("stability.svg",),
            "error-time": ("error-time.svg",), "evidence": ()}
# A rerun on another machine may differ by roundings, which some of these runs amplify.
AGREES = 1e-3
# What tests measure is rounding in part, and that differs by a factor from one processor to another.
WORSE, OF_TESTS = 3.0, 0.05
FIRST_VALUES = 3


def power(value, digits=1):
    """A number as people write it: 3.7·10⁻⁵."""
    if value == 0:
        return "0"
    if 1e-2 <= abs(value) < 1e4:
        return f"{value:.{digits + 1}g}"
    mantissa, exponent = f"{value:.{digits}e}".split("e")
    return f"{mantissa}·10{str(int(exponent)).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"


def plain(value):
    """A number that was chosen, as short as it can be said."""
    if value == int(value) and abs(value) < 1e5:
        return str(int(value))
    text = f"{value:g}" if 1e-3 <= abs(value) < 1e5 else power(value, 0)
    return text.removeprefix("1·")


def measured(value):
    """A number that was measured, with three digits."""
    if isinstance(value, int):
        return str(value)
    return f"{value:#.3g}" if 1e-2 <= abs(value) < 1e3 else power(value)


def at_most(value):
    """A number of two digits that is not below the value."""
    if value == 0:
        return "0"
    unit = 10.0 ** (math.floor(math.log10(abs(value))) - 1)
    return power(math.ceil(value / unit - 1e-6) * unit)


def table(head, rows):
    """A table in Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(cells)} |" for cells in lines)


def statements_3(main):
    """The paper's statements on its pendulum."""
    locking = main["locking"]
    by_nu = {case["nu"]: [ratio for _, ratio in case["ratios"]] for case in locking["small_load"] if case["poisson"] == "full"}
    tips = "; ".join(f"ν = {nu}: {min(ratios):.4f} … {max(ratios):.4f}" for nu, ratios in by_nu.items())
    large = ", ".join(f"{power(error)} ({elements})" for elements, error in locking["large_bending"])
    rows = [[locking["statement"], f"one element over Timoshenko's cantilever, L/h = 2 … 1000, {tips}; PL²/EI = 10, h/L = 10⁻³: the tip's "
             f"distance from the elastica over L (elements) {large}", locking["verdict"]]]
    for claim in main["statements"]:
        numbers = [", ".join(power(finding["value"]) for finding in claim[start]) for start in ("sudden", "relaxed")]
        limits = ", ".join(str(limit) for limit in claim["limits"])
        rows.append([claim["statement"], f"{claim['measure']} {limits}. Sudden: {numbers[0]}. Relaxed: {numbers[1]}",
                     claim["verdict"].replace("\n", "<br>")])
    return table(["statement", "measured", "verdict"], rows)


def distances(main):
    """How far models are from the solid."""
    rows = []
    for model in ("flexible", "2d-relaxed", "2d-sudden", "flexible-eb"):
        its = [row for row in main["errors"] if row["model"] == model]
        largest = lambda key, until: max(row[key] for row in its if row["window"]["to"] <= until)
        rows.append([model, *(power(largest("distance", until)) for until in (0.5, 1, 2)),
                     *(power(largest(key, 2)) for key in ("space", "time", "reference"))])
    return table(["", "to 0.5 s", "to 1 s", "to 2 s", "to 2 s: twice the elements change", "twice the step", "the solid's own"], rows)


def tips(main):
    """Positions of the tip."""
    models = ("flexible", "2d-sudden", "2d-relaxed")
    of = {(row["model"], row["t"]): row for row in main["tip"]}
    cell = lambda row: f"{row['tip'][0]:.6f}, {row['tip'][1]:.6f} ({power(row['change_with_the_other_mesh'])})".replace("-", "−")
    rows = [[f"{t} s", *(cell(of[model, t]) for model in models)] for t in (0.25, 0.5, 1.0, 1.5, 2.0)]
    return table(["t", *(f"{model} x, y" for model in models)], rows)


def shear(main):
    """The flexible tip without and with a shear correction."""
    window = lambda row: f"{row['window']['from']} … {row['window']['to']} s"
    return table(["window", "distance from the solid, m", "with a shear correction factor of 5/6, m"],
                 [[window(row), power(row["distance"]), power(row["corrected"])] for row in main["shear"]])


def statements_4(main):
    """The paper's statements on its structure."""
    families = ("undamped", "half_the_elements", "twice_the_step", "damped")
    shown = lambda numbers: ", ".join(numbers.split(", ")[:FIRST_VALUES]) + (" …" if numbers.count(", ") >= FIRST_VALUES else "")
    rows = [[claim["statement"], claim["measure"], *(shown(claim[family]["numbers"]) for family in families), claim["verdict"]]
            for claim in main["claims"]]
    return table(["statement", "measured", "undamped", "half the elements", "twice the step", "damped", "verdict"], rows)


def readings(result):
    """Whether the paper's statements on its structure hold under other readings."""
    names = [read["reading"] for read in result["readings"]]
    rows = [[brief, *(read["standings"][n][1].replace("-", " ") for read in result["readings"])]
            for n, (brief, _) in enumerate(result["readings"][0]["standings"])]
    return table(["statement", *names], rows) + f"\n\n{made(result)}"


def made(result):
    """How results were obtained."""
    return f"`{result['command']}` at commit {result['commit']}, {result['machine']}."


def stability_counts(result):
    """Rows of the stability table by case and verdict."""
    verdicts = ("right", "right with warning", "refused", "WRONG")
    rows = [[name, *(str(case["counts"][verdict]) for verdict in verdicts), str(case["counts"]["~"])] for name, case in result["cases"].items()]
    total = ["**total**", *(str(sum(int(row[n]) for row in rows)) for n in range(1, 6))]
    return table(["case", *verdicts, "~"], [*rows, total]) + f"\n\n{made(result)}"


def stability_cases(result):
    """What each case sweeps, how far it holds, and the row whose error is nearest to its bound."""
    def reach(values):
        if not values:
            return "–"
        shown = [plain(value) for value in (min(values), max(values))]
        return " … ".join(dict.fromkeys(shown))

    rows = []
    for name, case in result["cases"].items():
        ends = [reach(case["values"][verdict]) for verdict in ("right", "right with warning", "refused")]
        nearest = case["nearest"]
        shown = "–"
        if nearest:
            shown = f"{power(nearest['error'])} of {power(nearest['bound'])} {case['unit'].split(' (')[0]} ({nearest['variant']}, {plain(nearest['value'])})"
        rows.append([f"`{name}`", case["reference"], case["parameter"], *ends, shown])
    return table(["case", "error, from", "swept", "right", "with a warning", "refused", "the error nearest to its bound"], rows)


def seconds(time):
    """A time with its unit, two or three digits."""
    for unit, factor in (("µs", 1e6), ("ms", 1e3)):
        if time * factor < 1000:
            return f"{time * factor:.3g} {unit}"
    return f"{time:.3g} s"


def how(point):
    """Method, mesh, step and tolerances of a run."""
    step = f"{label(point['tolerance'])} m" if point["tolerance"] else f"{power(1 / point['step'])} load steps" if point["method"] == "static" \
        else f"{power(point['step'])} s"
    newton = f", Newton {label(point['newton_tolerance'])}" if point["newton_tolerance"] else ""
    return f"{point['method']}, {point['elements']}, {step}{newton}"


def label(below):
    """A power of ten, or another number with one digit."""
    mantissa, exponent = f"{below:.0e}".split("e")
    return f"{mantissa}·10".removeprefix("1·") + str(int(exponent)).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def quartiles(ratio):
    """A ratio with its quartiles."""
    return f"{ratio['ratio']:.1f} ({ratio['least']:.1f} … {ratio['most']:.1f})" if ratio else "–"


def fastest(result, element):
    """The fastest runs with an element, beside another program's."""
    rows = []
    for winner in result["winners"]:
        if winner["element"] == element:
            ours, theirs = winner["ours"], winner["theirs"]
            other = [f"{seconds(theirs['time']['median'])}: {theirs['element']}, {how(theirs)}", quartiles(winner["ratio"])] if theirs else ["–", "–"]
            rows.append([f"`{winner['scene']}`", f"{label(winner['below'])} m", f"{seconds(ours['time']['median'])}: {how(ours)}",
                         power(winner["bound"]), *other])
    return table(["scene", "error below", "ours: method, elements, step", "its bound, m", "Exudyn", "ratio"], rows)


def fastest_cable(result):
    """Without shear."""
    return fastest(result, "euler-bernoulli")


def fastest_shear(result):
    """With shear."""
    return fastest(result, "ancf")


def parts(result):
    """Where errors come from, for the most accurate run of each scene and element."""
    number = lambda value: "–" if value is None else power(value)
    rows = []
    for group in result["groups"]:
        its = [w for w in result["winners"] if (w["scene"], w["element"]) == (group["scene"], group["element"])]
        errors = its[-1]["ours"]["errors"] if its else {}
        reference, model = group["reference"], group["model"]
        rows.append([f"`{group['scene']}`, {group['element']}", f"{power(reference['uncertainty'])} ({reference['elements']})",
                     f"{label(its[-1]['below'])} m" if its else "–",
                     *(number(errors.get(key)) for key in ("position", "time", "space", "velocity", "reaction", "energy")),
                     number(reference["velocity"]), number(reference["reaction"]),
                     f"{power(model['distance'])} ± {power(model['uncertainty'], 0)}" if model else "–"])
    return table(["scene, element", "reference ±, m (elements)", "fastest run below", "error, m", "in time", "in space", "velocity, m/s", "reaction, N",
                  "energy balance, J", "reference's velocity ±", "reaction ±", "theory against the continuum, m"], rows)


def economies(result):
    """What leaving out saves."""
    rows = [[one["what"], f"{one['with']['median'] / one['without']['median']:.2f}", seconds(one["with"]["median"]), seconds(one["without"]["median"]),
             power(one["difference"], 0), one["scene"]] for one in result["economies"]]
    return table(["left out", "time with it over time without", "with", "without", "change, m", "on"], rows)


def made_error_time(result):
    """Machine, duration, disturbances."""
    times = [point["time"] for winner in result["winners"] for point in (winner["ours"], winner["theirs"]) if point]
    disturbed, runs = (sum(time[key] for time in times) for key in ("disturbed", "runs"))
    return (f"{made(result)} {result['peer']} All of it took {result['wall_seconds'] / 60:.0f} minutes; of {runs} runs in these tables {disturbed} "
            f"({100 * disturbed / runs:.0f} %) were disturbed in every attempt, and count all the same.")


def performance(result):
    """The README's sentence."""
    find = lambda element: [w for w in result["winners"] if (w["scene"], w["element"], w["below"]) == ("pendulum-flexible", element, 1e-3)]
    clauses = []
    for element, name, other in (("euler-bernoulli", "Euler–Bernoulli", "cable element"), ("ancf", "the paper's element", "beam with shear")):
        for winner in find(element):
            ratio = f", Exudyn's {other} {winner['ratio']['ratio']:.1f} times as long" if winner["ratio"] else ""
            clauses.append(f"{name} takes {seconds(winner['ours']['time']['median'])}{ratio}")
    return f"Two seconds of the flexible pendulum, its tip within a millimetre at every instant, on one core: {'; '.join(clauses)} ({result['machine']})."


BLOCKS = {
    ("paper.md", "statements-3", "main"): statements_3,
    ("paper.md", "distances", "main"): distances,
    ("paper.md", "tips", "main"): tips,
    ("paper.md", "shear", "main"): shear,
    ("paper.md", "statements-4", "main"): statements_4,
    ("paper.md", "readings", "readings"): readings,
    ("paper.md", "made", "main"): made,
    ("stability.md", "counts", "stability"): stability_counts,
    ("stability.md", "cases", "stability"): stability_cases,
    ("evidence.md", "measured", "evidence"): made,
    ("error-time.md", "fastest-cable", "error-time"): fastest_cable,
    ("error-time.md", "fastest-shear", "error-time"): fastest_shear,
    ("error-time.md", "parts", "error-time"): parts,
    ("error-time.md", "economies", "error-time"): economies,
    ("error-time.md", "made", "error-time"): made_error_time,
    ("../README.md", "error-time", "error-time"): performance,
}


def main_values(main):
    """Numbers of the main job that pages tell in their sentences."""
    of = lambda rows, key, pick=lambda row: True: max(row[key] for row in rows if pick(row))
    is_sudden = lambda row: "sudden" in row["run"]
    is_pinned = lambda row: row["run"].startswith(("scissor-", "knee-"))
    is_of = lambda *models: lambda row: row["model"] in models
    early = lambda model: lambda row: row["model"] == model and row["window"]["to"] <= 0.5
    return {
        "pendulum-smooth": of(main["oracle"], "largest_distance", lambda row: not is_sudden(row)),
        "pendulum-sudden": of(main["oracle"], "largest_distance", is_sudden),
        "pendulum-oracle": of(main["oracle"], "oracle_error"),
        "structures": of(main["structures"], "largest_distance", is_pinned),
        "structures-oracle": of(main["structures"], "oracle_error", is_pinned),
        "scissors-balance": max(row["largest"] / row["input"] for row in main["energy"]),
        "solid-flexible": of(main["errors"], "reference", early("flexible")),
        "solid-sudden": of(main["errors"], "reference", early("2d-sudden")),
        "step-smooth": of(main["tip"], "change_with_twice_the_step", is_of("flexible", "2d-relaxed")),
        "step-sudden": of(main["tip"], "change_with_twice_the_step", is_of("2d-sudden")),
    }


def inline(page, text, check):
    """The page's text with its numbers, and what is wrong."""
    faults = []

    def told(match):
        result, name, shown = match.groups()
        if result not in COMMANDS or not kept(result).exists():
            faults.append(f"{page}: no result {result}")
            return match[0]
        values = json.loads(kept(result).read_text(encoding="utf-8"))
        values = {name: ("at-most", value) for name, value in main_values(values).items()} if result == "main" else values["measured"]
        row = [values[each] for each in values if each == name or name[-2:] in (".*", ".~") and each.startswith(name[:-1])]
        if not row:
            faults.append(f"{page}: {result} has no {name}")
            return match[0]
        number = lambda kind, value: at_most(value) if kind == "at-most" else measured(value)
        if name.endswith(".~"):
            least, largest = (edge(row, key=lambda each: each[1]) for edge in (min, max))
            new = f"{number(*least)} … {number(*largest)}"
        else:
            new = ", ".join(number(*each) for each in row)
        if check and new != shown:
            faults.append(f"docs/{page}: {shown} is not what {result} gives for {name}, {new}: run docs/numbers.py")
        return f"<!--={result}:{name}-->{new}<!--/-->"

    return re.sub(r"<!--=([\w-]+):([^ >]+?)-->(.*?)<!--/-->", told, text), faults


def kept(name):
    """The file of a result."""
    return READINGS if name == "readings" else RESULTS / f"{name}.json"


def slim(name, result):
    """What the pages need of a result."""
    if name == "evidence":
        return {"measured": result}
    if name == "readings":
        return {"readings": result["readings"]}
    if name == "main":
        return {key: value for key, value in result.items() if key not in ("run", "wall_seconds")}
    if name == "error-time":
        groups = [{key: group[key] for key in ("scene", "element", "reference", "space", "model")} for group in result["groups"]]
        return {key: result[key] for key in ("peer", "wall_seconds")} | {"groups": groups, "winners": result["winners"], "economies": result["economies"]}
    cases = {}
    for case in result["cases"]:
        counts = dict.fromkeys(("right", "right with warning", "refused", "WRONG", "~"), 0)
        values = {verdict: [] for verdict in counts if verdict != "~"}
        for row in case["rows"]:
            counts[row["verdict"]] += 1
            counts["~"] += row["loose"]
            # Where a variant is refused, or warns, that is told, whatever others do.
            values[row["verdict"]].append(row["value"])
        judged = [row for row in case["rows"] if row["error"] and row["bound"]]
        nearest = max(judged, key=lambda row: row["error"] / row["bound"], default=None)
        cases[case["name"]] = {
            "reference": case["reference"],
            "parameter": case["parameter"],
            "unit": case["unit"],
            "counts": counts,
            "values": {verdict: sorted({value for value in of if value is not None}) for verdict, of in values.items()},
            "nearest": nearest and {key: nearest[key] for key in ("variant", "value", "error", "bound")},
        }
    return {"cases": cases}


def read(name, place):
    """A new result: a file of a folder, or for `evidence` the file that tests wrote."""
    if name != "evidence":
        return json.loads((place / f"{name}.json").read_text(encoding="utf-8"))
    measured = {}
    for line in place.read_text(encoding="utf-8").splitlines():
        kind, key, value = line.split(" ")
        value = float(value) if re.search(r"[.eE]|inf|NaN", value) else int(value)
        # A test that is run twice, or beside others, tells the same names again.
        measured[key] = [kind, max(value, measured.get(key, [kind, value])[1]) if kind == "at-most" else value]
    natural = lambda key: [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", key)]
    return {key: measured[key] for key in sorted(measured, key=natural)}


def take(name, folder):
    """Keeps a result and its pictures."""
    RESULTS.mkdir(exist_ok=True)
    commit = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
    cpus = Path("/proc/cpuinfo")
    processors = re.findall(r"^model name\s*: (.*)$", cpus.read_text(encoding="utf-8"), re.MULTILINE) if cpus.exists() else []
    machine = f"{processors[0] if processors else platform.processor()}, {len(processors) or '?'} cores, {platform.system()}"
    made_by = {"command": COMMANDS[name], "commit": commit, "machine": machine}
    result = read(name, folder)
    if name == "error-time":
        made_by["commit"] = (result["machine"]["commit"] or "unknown")[:7]
        made_by["command"] += " --quick" * result["options"]["quick"] + "".join(f" {scene}" for scene in result["options"]["scenes"])
    result = made_by | slim(name, result)
    kept(name).write_text(json.dumps(result, ensure_ascii=False, indent=1) + "\n", encoding="utf-8")
    for picture in PICTURES[name]:
        shutil.copy(folder / picture, PAGES / picture)


def pages(check):
    """Writes the blocks, or compares them. Returns what differs."""
    faults = []
    for (page, block, name), write in BLOCKS.items():
        path, begin, end = (PAGES / page).resolve(), f"<!-- {block}:begin -->\n", f"\n<!-- {block}:end -->"
        text = path.read_text(encoding="utf-8")
        if text.count(begin) != 1 or text.count(end) != 1:
            faults.append(f"{page}: needs the block {block} once")
            continue
        if not kept(name).exists():
            faults.append(f"{page}: {kept(name).relative_to(ROOT)} is missing: run `{COMMANDS[name]}`, then docs/numbers.py --take {name} out")
            continue
        before, rest = text.split(begin)
        shown, after = rest.split(end)
        new = write(json.loads(kept(name).read_text(encoding="utf-8")))
        if check and shown != new:
            faults.append(f"{path.relative_to(ROOT) if path.is_relative_to(ROOT) else page}: the block {block} is not what {kept(name).relative_to(ROOT)} gives: run docs/numbers.py")
        elif not check:
            path.write_text(before + begin + new + end + after, encoding="utf-8")
    for path in [*sorted(PAGES.glob("*.md")), ROOT / "README.md"]:
        text = path.read_text(encoding="utf-8")
        new, wrong = inline(path.name, text, check)
        faults += wrong
        if not check and new != text:
            path.write_text(new, encoding="utf-8")
    return faults


def differences(old, new, place):
    """Where a new run differs from what is kept."""
    if isinstance(old, dict) and isinstance(new, dict):
        return [fault for key in old if key not in ("command", "commit", "machine")
                for fault in differences(old[key], new.get(key), f"{place}.{key}")]
    if isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        return [fault for n, (a, b) in enumerate(zip(old, new)) for fault in differences(a, b, f"{place}[{n}]")]
    # Distances of right runs from their oracle are roundings in part.
    if isinstance(old, float) and isinstance(new, float) and math.isclose(old, new, rel_tol=AGREES, abs_tol=1e-9):
        return []
    return [] if old == new else [f"{place}: {old} is kept, the run gives {new}"]


def other_measurements(old, new):
    """What tests measure that is worse than what is kept, or another number, or lacking. A faster build may leave release tests out."""
    faults = []
    for key, (kind, value) in new["measured"].items():
        _, known = old["measured"].get(key, (kind, None))
        if known is None:
            faults.append(f"evidence.{key}: {value} is measured, and nothing kept")
        elif kind == "at-most" and not value <= max(WORSE * known, 1e-20):
            faults.append(f"evidence.{key}: {known} is kept, the test gives {value}")
        elif kind == "number" and not math.isclose(value, known, rel_tol=OF_TESTS, abs_tol=1e-12):
            faults.append(f"evidence.{key}: {known} is kept, the test gives {value}")
    return faults


def main():
    """Takes, writes or compares."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--take", nargs=2, metavar=("NAME", "FOLDER"), help=f"keep the result of a run: {', '.join(COMMANDS)}")
    parser.add_argument("--check", action="store_true", help="compare, and write nothing")
    parser.add_argument("--run", nargs=2, metavar=("NAME", "FOLDER"), help="compare what is kept with the result of a run, too")
    options = parser.parse_args()
    for given in (options.take, options.run):
        if given and given[0] not in COMMANDS:
            parser.error(f"{given[0]} is no result: {', '.join(COMMANDS)}")
    if options.take:
        take(options.take[0], Path(options.take[1]))
    faults = pages(options.check)
    if options.run:
        name, folder = options.run
        old, new = json.loads(kept(name).read_text(encoding="utf-8")), slim(name, read(name, Path(folder)))
        faults += other_measurements(old, new) if name == "evidence" else differences(old, new, name)
    for fault in faults:
        print(f"FAULT: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
