"""Runs `ancf conform` on each mistake, convention and bad habit of `element.cpp`, and counts what it recognises.

Exit code 1 where less is recognised than is asked of the kit (BARS), or a right equation is accused.
"""

import argparse
import json
import re
import shlex
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from mistakes import (
    BY_NAME, CONVENTIONS, CONVENTIONS_IN, GIVEN, MEMORIES, MISTAKES, PAIRS, PRECISIONS, TALKS,
)

HERE = Path(__file__).resolve().parent
FIXTURES = HERE.parents[2] / "fixtures"

# Keys of conformance.json, and what a program says in `hello` about the layout that it reads.
PASSES, FIRST, CULPRITS = "passes", "first_wrong", "culprits"
QUANTITY, EQUATION, KINDS, KIND, ANCESTORS = "quantity", "equation", "kinds", "kind", "ancestors"
CONVENTIONS_KEY, PRECISION_KEY, MEMORY_KEY = "conventions", "precision", "memory"
DECLARATION = '"conventions": {"name": "%s"}'

BLACK_BOX = "M,Q_e,tangent,Q_w"
BLACK_BOX_NAMES = {
    "M": "7.M cable.M", "Q_e": "19.Q_e cable.Q_e", "tangent": "tangent.dQ_e cable.tangent",
    "Q_w": "gravity.Q_w cable.Q_w", "U": "18.U cable.U", "T": "6.T cable.T",
}
SETS = ("double", "float", "black-box", "conventions", "conventions-in", "precision", "memory", "given", "pairs",
        "talk")
FLOAT_ROUNDING = 6e-8
MARKERS = ("<!-- counts: run.py --table -->", "<!-- end of counts -->")


# ---------------------------------------------------------------------------------------------- the program by itself


def build(folder):
    """Compiles the program."""
    program = folder / "element"
    subprocess.run(["g++", "-std=c++17", "-O1", "-o", program, HERE / "element.cpp"], check=True)
    return program


def flat(value):
    """Numbers of nested lists, in order."""
    return [number for part in value for number in flat(part)] if isinstance(value, list) else [value]


def questions():
    """Every question with its reference: (quantity, case), line, numbers, tolerances."""
    out = []
    for name in ("equations", "cable", "structure"):
        fixture = json.loads((FIXTURES / f"{name}.json").read_text())
        for case in fixture.get("states", fixture.get("cases")):
            values = case["values"]
            given = {key: values[key]["f64"] for key in ("23.m", "23.Q_e", "23.f", "23.Phi_q") if key in values}
            for quantity, value in values.items():
                if "/printed" in quantity or quantity in given:
                    continue
                line = {"id": "1", "equation": quantity, "state": case["state"]}
                if given:
                    line["given"] = given
                numbers, absolute = flat(value["f64"]), flat(value["absolute"])
                if len(absolute) == 1:
                    absolute = absolute * len(numbers)
                out.append(((quantity, case["id"]), json.dumps(line), numbers, absolute))
    return out


def answers(program, options, asked):
    """The program's numbers by (quantity, case); None where it has none."""
    text = "".join(line + "\n" for _, line, _, _ in asked)
    done = subprocess.run([program, *options], input=text, capture_output=True, text=True, check=True)
    out = {}
    for (key, *_), line in zip(asked, done.stdout.splitlines(), strict=True):
        try:
            value = json.loads(line).get("value")
        except json.JSONDecodeError:  # nan or inf
            value = None
        out[key] = None if value is None else flat(value)
    return out


def visible(wrong, clean, asked, single):
    """Quantities that a mistake changes: beyond the tolerance, or beyond 30 times what single precision leaves."""
    out = set()
    for key, _, numbers, absolute in asked:
        ours, theirs = clean[key], wrong[key]
        if ours is None:
            continue
        if theirs is None or len(theirs) != len(ours):
            out.add(key[0])
            continue
        changed = max(abs(a - b) / unit for a, b, unit in zip(ours, theirs, absolute))
        own = max(abs(a - b) / unit for a, b, unit in zip(ours, numbers, absolute))
        if changed > (30 * max(own, FLOAT_ROUNDING / 1e-13) if single else 1) or changed != changed:
            out.add(key[0])
    return out


# ------------------------------------------------------------------------------------------------------ asking the kit


def examine(ancf, program, options, limit=300):
    """Exit code, report and text of the kit for the program with these options."""
    with tempfile.TemporaryDirectory() as out:
        command = [ancf, "conform", "--out", out, "--", program, *options]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=limit)
        except subprocess.TimeoutExpired:
            return None, {}, ""
        report = Path(out) / "conformance.json"
        if not report.exists():
            return done.returncode, {}, done.stdout + done.stderr
        return done.returncode, json.loads(report.read_text()), done.stdout + report.read_text()


def options_of(*names):
    """Options of the program that makes these mistakes; the paper's route if one needs it."""
    out = [word for name in names for word in ("--mistake", name)]
    if any(BY_NAME[name].route == "paper" for name in names):
        out += ["--route", "paper"]
    return out


def kinds_of(result):
    """Names of the kinds of a culprit or an ancestor, likelier ones first."""
    return [kind if isinstance(kind, str) else kind[KIND] for kind in result.get(KINDS) or []]


def fits(kinds, mistake):
    """Whether one of the kinds describes the mistake."""
    return any(kind in mistake.kinds or any(word in kind for word in mistake.words) for kind in kinds)


def is_root(result, mistake):
    """Whether a culprit or an ancestor is where the mistake is."""
    return result.get(QUANTITY) in mistake.quantities


def others(report, *roots):
    """Culprits that no mistake makes wrong by itself."""
    return [culprit[QUANTITY] for culprit in report.get(CULPRITS, [])
            if not any(culprit[QUANTITY] in root.quantities + root.also for root in roots)]


def verdict(report, mistake):
    """Detected, right equation, right kind, nothing else accused, and what was said."""
    first = report.get(FIRST) or {}
    kinds = kinds_of(first)
    right = is_root(first, mistake)
    more = others(report, mistake)
    said = f"{first.get(QUANTITY)} {', '.join(kinds) or '-'}" + (f"; accused too {' '.join(more)}" if more else "")
    return report.get(PASSES) is False, right, right and fits(kinds, mistake), not more, said


def verdict_of_box(report, mistake, asked_for):
    """Whether the right ancestor is named, or a wrong one accused, by a program that answers few quantities."""
    first = report.get(FIRST) or {}
    ancestors = first.get(ANCESTORS)
    said = f"{first.get(QUANTITY)} {', '.join(kinds_of(first)) or '-'}"
    if any(quantity in asked_for for quantity in mistake.quantities):
        right = is_root(first, mistake)
        return right, bool(first) and not right, said
    if first.get(QUANTITY) in mistake.also and fits(kinds_of(first), mistake):
        return True, False, said
    if ancestors is None:
        # A kind at a right equation accuses it.
        return False, bool(kinds_of(first)), said
    said += " <- " + ", ".join(f"{a.get(QUANTITY)} {'/'.join(kinds_of(a)) or '-'}" for a in ancestors)
    right = any(is_root(ancestor, mistake) for ancestor in ancestors)
    accused = [ancestor for ancestor in ancestors if kinds_of(ancestor)]
    return right, not right and bool(accused or kinds_of(first)), said


# What is asked of the kit: least part of the programs, by the beginning of a set's title and by what is counted.
BARS = (
    ("double", "detected", 1.0), ("double", "equation", 0.98), ("double", "kind", 0.85),
    ("float", "equation", 0.9), ("black box", "right", 0.7),
    ("conventions", "right", 1.0), ("conventions", "named", 1.0), ("precision", "right", 1.0), ("given", "right", 1.0),
    ("memory", "recognised", 1.0), ("pairs", "both named", 0.9), ("talk", "as it should be", 1.0),
)


def missed(counted):
    """The bars that are not reached, and wrong accusations."""
    faults = [f"{title}: {number} wrong accusations" for title, what, number, _ in counted if what == "wrong accusation" and number]
    for begin, what, least in BARS:
        its = [(number, total) for title, counts, number, total in counted if title.startswith(begin) and counts == what]
        number, total = (sum(column) for column in zip(*its)) if its else (0, 0)
        if number < least * total:
            faults.append(f"{begin}: {what} in {number} of {total}, less than {least:.0%}")
    return faults


def written(text, counted):
    """The text with the table between its markers; rows of sets that were not run stay as they are."""
    before, _, rest = text.partition(MARKERS[0])
    old, mark, after = rest.partition(MARKERS[1])
    if not mark:
        sys.exit(f"the file has no lines {MARKERS[0]} and {MARKERS[1]}")
    rows = {}
    for line in old.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 4 and cells[2].isdigit():
            rows[cells[0], cells[1]] = line
    fresh = {title for title, *_ in counted}
    rows = {key: line for key, line in rows.items() if key[0] not in fresh}
    rows |= {(title, what): f"| {title} | {what} | {number} | {total} |" for title, what, number, total in counted}
    lines = ["| set | count | programs | of |", "|---|---|---|---|", *sorted(rows.values())]
    return before + MARKERS[0] + "\n" + "\n".join(lines) + "\n" + MARKERS[1] + after


class Runner:
    """The sets, each a method."""

    def __init__(self, ancf, program, only):
        self.ancf, self.program = ancf, program
        self.asked = questions()
        self.pool = ThreadPoolExecutor(2)
        self.box = [name for key in only.split(",") for name in BLACK_BOX_NAMES.get(key, key).split()]
        self.results = {}
        self.counts = []

    def table(self, title, rows, counted, total):
        """Prints counts, then the rows that are not as they should be."""
        print(f"\n## {title}\n")
        for what, number in counted.items():
            self.counts.append((title, what, number, total))
            print(f"{what}: {number} of {total}" + (f" ({100 * number / total:.1f} %)" if total else ""))
        for row in rows:
            print("  " + "  ".join(str(cell) for cell in row))
        sys.stdout.flush()

    def reports(self, tasks):
        """Reports by task name, two at a time."""
        return dict(zip(tasks, self.pool.map(lambda o: examine(self.ancf, self.program, o), tasks.values())))

    def changes(self, single):
        """Quantities that each mistake changes."""
        extra = ["--float"] if single else []
        clean = {route: answers(self.program, ["--route", route, *extra], self.asked) for route in ("stress", "paper")}

        def one(mistake):
            wrong = answers(self.program, options_of(mistake.name) + extra, self.asked)
            return visible(wrong, clean[mistake.route], self.asked, single)

        return dict(zip((mistake.name for mistake in MISTAKES), self.pool.map(one, MISTAKES)))

    def mistakes(self, name, single):
        """Every visible mistake with all quantities answered."""
        changes = self.changes(single)
        unseen = [n for n, changed in changes.items() if not changed]
        chosen = [mistake for mistake in MISTAKES if changes[mistake.name]]
        extra = ["--float"] if single else []
        reports = self.reports({mistake.name: options_of(mistake.name) + extra for mistake in chosen})
        for part in ("beam", "cable"):
            mine = [mistake for mistake in chosen if (mistake.equation == "cable") == (part == "cable")]
            counts, rows = {"detected": 0, "equation": 0, "kind": 0, "nothing else accused": 0}, []
            for mistake in mine:
                detected, equation, kind, alone, said = verdict(reports[mistake.name][1], mistake)
                for what, right in zip(counts, (detected, equation, kind, alone)):
                    counts[what] += right
                self.results[f"{name} {mistake.name}"] = [detected, equation, kind, alone, said]
                if not (kind and alone):
                    fault = "accused" if kind else "kind" if equation else "equation" if detected else "not detected"
                    rows.append((fault, mistake.name, "| is", *mistake.quantities, *mistake.kinds, "| said", said))
            self.table(f"{name}, {part}", sorted(rows), counts, len(mine))
        print("changes nothing that is visible:", *unseen or ["none"])

    def black_box(self):
        """Every mistake that the answered quantities show."""
        changes = self.changes(False)
        chosen = [mistake for mistake in MISTAKES if changes[mistake.name] & set(self.box)]
        only = ["--only", ",".join(self.box)]
        reports = self.reports({mistake.name: options_of(mistake.name) + only for mistake in chosen})
        for title, answered in (("root answered", True), ("root not answered", False)):
            mine = [mistake for mistake in chosen if bool(set(mistake.quantities) & set(self.box)) == answered]
            counts, rows = {"right": 0, "wrong accusation": 0}, []
            for mistake in mine:
                right, wrong, said = verdict_of_box(reports[mistake.name][1], mistake, self.box)
                counts["right"] += right
                counts["wrong accusation"] += wrong
                self.results[f"black-box {mistake.name}"] = [right, wrong, said]
                if not right:
                    rows.append(("accused" if wrong else "unnamed", mistake.name, *mistake.quantities, "| said", said))
            self.table(f"black box ({', '.join(self.box)}), {title}", sorted(rows), counts, len(mine))

    def right_programs(self, title, tasks, key, words):
        """Programs that are right: they have to pass, and the report's key to say what they are."""
        reports = self.reports(tasks)
        counts, rows = {"right": 0, "named": 0}, []
        for name, (code, report, _) in reports.items():
            passes = report.get(PASSES) is True and not report.get(FIRST)
            said = json.dumps(report.get(key), ensure_ascii=False).lower() if report.get(key) else ""
            named = bool(said) and (not words.get(name) or any(word in said for word in words[name]))
            counts["right"] += passes
            counts["named"] += named
            self.results[f"{title} {name}"] = [passes, named]
            if not (passes and named):
                failing = sum(result["fail"] > 0 for result in report.get("quantities", []))
                first = report.get(FIRST) or {}
                rows.append((name, "passes" if passes else f"fails in {failing} quantities", "| exit", code,
                             "| first", first.get(QUANTITY), *kinds_of(first), "| named" if named else "| not named"))
        self.table(title, rows, counts, len(tasks))

    def conventions(self):
        """Other conventions in the answers."""
        tasks = {name: ["--convention", name] for name in CONVENTIONS}
        self.right_programs("conventions", tasks, CONVENTIONS_KEY, CONVENTIONS)

    def conventions_in(self):
        """Other conventions in the state too, declared in `hello`."""
        tasks = {name: ["--convention-in", name, "--declare", DECLARATION % name] for name in CONVENTIONS_IN}
        self.right_programs("conventions-in", tasks, CONVENTIONS_KEY, {})

    def precision(self):
        """Little precision."""
        self.right_programs("precision", PRECISIONS, PRECISION_KEY, {})

    def memory(self):
        """Programs whose answers depend on earlier questions."""
        reports = self.reports({name: ["--route", "paper", "--memory", name] for name in MEMORIES})
        counts, rows = {"detected": 0, "recognised": 0}, []
        for name, (_, report, _) in reports.items():
            known = bool(report.get(MEMORY_KEY))
            counts["detected"] += report.get(PASSES) is False
            counts["recognised"] += known
            self.results[f"memory {name}"] = known
            if not known:
                first = report.get(FIRST) or {}
                rows.append((name, "| said", first.get(QUANTITY), *kinds_of(first)))
        self.table("memory", rows, counts, len(reports))

    def given(self):
        """Intermediate values that are announced and ignored, and announced and read."""
        # The paper's route takes each value that the kit hands over; the other has no use for some.
        tasks = {f"lie {name}": ["--given", "lie", *options_of(name)] for name in GIVEN}
        tasks.update({f"read {name}": ["--given", "read", "--mistake", name, "--route", "paper"] for name in GIVEN})
        for way in ("lie", "read"):
            tasks[f"{way} clean"] = ["--given", way, "--route", "paper"]
        reports = self.reports(tasks)
        counts, rows = {"right": 0}, []
        for name, (_, report, _) in reports.items():
            culprits = [culprit[QUANTITY] for culprit in report.get(CULPRITS, [])]
            mistake = BY_NAME.get(name.split()[1])
            right = not culprits and report.get(PASSES) is True
            if mistake:
                right = bool(culprits) and not others(report, mistake)
            counts["right"] += right
            self.results[f"given {name}"] = right
            if not right:
                rows.append((name, "| accused", *culprits))
        self.table("given: no culprit but the root", rows, counts, len(reports))

    def pairs(self):
        """Two mistakes at once: both roots have to be among the culprits."""
        reports = self.reports({pair: options_of(*pair) for pair in PAIRS})
        counts, rows = {"both named": 0, "nothing else accused": 0}, []
        for pair, (_, report, _) in reports.items():
            roots = [BY_NAME[name] for name in pair]
            culprits = report.get(CULPRITS, [])
            both = all(any(is_root(culprit, root) for culprit in culprits) for root in roots)
            only = bool(culprits) and not others(report, *roots)
            counts["both named"] += both
            counts["nothing else accused"] += only
            self.results["pair " + " + ".join(pair)] = [both, only]
            if not (both and only):
                said = [f"{culprit[QUANTITY]}({'/'.join(kinds_of(culprit))})" for culprit in culprits]
                rows.append((" + ".join(pair), "| said", *said))
        self.table("pairs", rows, counts, len(reports))

    def talk(self):
        """Bad formats."""
        reports = self.reports({name: ["--talk", name] for name in TALKS})
        counts, rows = {"as it should be": 0}, []
        for name, (code, report, text) in reports.items():
            word = TALKS[name]
            right = report.get(PASSES) is True if word is None else bool(re.search(word, text))
            counts["as it should be"] += right
            self.results[f"talk {name}"] = right
            if not right:
                first = report.get(FIRST) or {}
                rows.append((name, "| exit", code, "| first", first.get(QUANTITY), str(first.get("because"))[:90]))
        self.table("talk", rows, counts, len(reports))


def check_names():
    """Stops where a mistake of the list is not in the program, or one of the program not in the list."""
    source = (HERE / "element.cpp").read_text()
    made = set(re.findall(r'\bm\("([^"]+)"\)', source))
    listed = {mistake.name for mistake in MISTAKES}
    if made != listed or len(listed) != len(MISTAKES):
        sys.exit(f"mistakes.py and element.cpp differ: {sorted(made ^ listed)}")


def main():
    """The command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--ancf", default="ancf", help="the program `ancf`")
    parser.add_argument("--precision", choices=("double", "float"), help="the mistakes in this precision only")
    parser.add_argument("--black-box", metavar="QUANTITIES", help="only what a black box shows, such as M,Q_e,tangent")
    parser.add_argument("--set", action="append", choices=SETS, help="sets to run; all if left out")
    parser.add_argument("--list", action="store_true", help="list the mistakes, each with the command of its program")
    parser.add_argument("--json", metavar="FILE", help="results, a line for each program")
    parser.add_argument("--table", metavar="FILE", help="write the counts into a file with the table's markers")
    arguments = parser.parse_args()
    check_names()
    if arguments.list:
        for mistake in MISTAKES:
            print(f"{mistake.equation:8} {shlex.join(options_of(mistake.name)):50} {mistake.what}")
        return
    chosen = arguments.set or ([arguments.precision] if arguments.precision else [])
    if arguments.black_box and not chosen:
        chosen = ["black-box"]
    with tempfile.TemporaryDirectory() as folder:
        runner = Runner(arguments.ancf, build(Path(folder)), arguments.black_box or BLACK_BOX)
        for route in ("stress", "paper"):
            code, report, _ = examine(arguments.ancf, runner.program, ["--route", route])
            if code != 0:
                print(f"the program without mistakes fails by the route {route}: {report.get(FIRST)}")
        for name in chosen or SETS:
            if name in ("double", "float"):
                runner.mistakes(name, name == "float")
            else:
                getattr(runner, name.replace("-", "_"))()
        if arguments.table:
            file = Path(arguments.table)
            file.write_text(written(file.read_text(), runner.counts))
        if arguments.json:
            Path(arguments.json).write_text(json.dumps(runner.results, indent=1) + "\n")
        faults = missed(runner.counts)
    for fault in faults:
        print(f"FAULT: {fault}")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
