"""The exercise sheets against the program: every command in them is run, every number claimed is looked up or computed.

    python teaching/check.py --ancf target/release/ancf      # needs Python 3.11, and the network for `pip install`

A fenced block `sh` is a command, run from a copy of the repository with no more than `ancf`, Python and the system's programs on the path.
A block `text` in a solution is what the commands of its task print, line by line. A number in bold is a claim: it is the value of the
Python expression in the comment behind it (`**12.5** <!-- = 25 / 2 -->`), or, to its last digit, a number that the task's commands print.
Each claim is also tried with another last digit, which must fail.
"""

import argparse
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from decimal import Decimal
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
ROOT = FOLDER.parent
COPIED = ("teaching", "fixtures", "oracle")
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
CLAIM = re.compile(r"\*\*([-−]?\d[\d ]*(?:\.\d+)?)\*\*(?:\s*[^<\n]{0,12}<!-- = (.+?) -->)?")
TASK = re.compile(r"^## (\d+)", re.MULTILINE)
NUMBER = re.compile(r"[-−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
# Fewer digits are found by chance: such a number needs an expression.
DIGITS = 3
LIMIT = 300.0
# What `pip` may need of the surroundings.
NETWORK = ("PIP_CACHE_DIR", "PIP_INDEX_URL", "HTTPS_PROXY", "https_proxy", "SSL_CERT_FILE")
NAMES = {"sqrt": math.sqrt, "pi": math.pi}


def tasks(text):
    """Pairs (number of the task, its text); what stands before the first is task 0."""
    parts = TASK.split(text)
    return [("0", parts[0]), *zip(parts[1::2], parts[2::2])]


def run(command, folder, environment):
    """What a command prints, as one text."""
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", command], cwd=folder, env=environment, text=True, timeout=LIMIT,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        raise SystemExit(f"exit code {done.returncode}:\n{command}\n{done.stdout}")
    return done.stdout


def holds(claim, expression, output):
    """Whether a claimed number is right to its last digit."""
    unit = 10.0 ** Decimal(claim).as_tuple().exponent
    if expression is None:
        values = [float(number.replace("−", "-")) for number in NUMBER.findall(output)]
    else:
        values = [float(eval(expression, {"__builtins__": {}}, NAMES))]
    return any(abs(value - float(claim)) <= 0.5 * unit * (1 + 1e-9) for value in values)


def neighbours(claim):
    """The claim with another last digit."""
    number = Decimal(claim)
    unit = Decimal(1).scaleb(number.as_tuple().exponent)
    return [str(number + 2 * unit), str(number - 2 * unit)]


def faults(name, task, text, output):
    """Claims and printed lines of a task that do not hold."""
    found, lines = [], {" ".join(line.split()) for line in output.splitlines()}
    for language, block in BLOCK.findall(text):
        if language == "text":
            found += [f"{name}, task {task}: not printed: {line}" for line in block.splitlines() if " ".join(line.split()) not in lines]
    for match in CLAIM.finditer(BLOCK.sub("", text)):
        claim, expression = match[1].replace(" ", "").replace("−", "-"), match[2]
        if expression is None and len(claim.strip("-0.").replace(".", "")) < DIGITS:
            found.append(f"{name}, task {task}: {claim} has few digits, and no expression")
        if not holds(claim, expression, output):
            found.append(f"{name}, task {task}: {claim} is not {expression or 'printed'}")
        found += [f"{name}, task {task}: {other} would pass for {claim}" for other in neighbours(claim) if holds(other, expression, output)]
    return found


def counts(text):
    """Numbers of commands, printed blocks and claims."""
    languages = [language for language, _ in BLOCK.findall(text)]
    return languages.count("sh"), languages.count("text"), len(CLAIM.findall(BLOCK.sub("", text)))


def environment(folder, ancf):
    """A path with `ancf`, and a home without anything in it."""
    programs = folder / "bin"
    programs.mkdir()
    (programs / "ancf").symlink_to(Path(ancf).resolve())
    (programs / "python3").symlink_to(sys.executable)
    fresh = {"PATH": f"{programs}:/usr/bin:/bin", "HOME": str(folder), "LANG": "C.UTF-8", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    return fresh | {name: os.environ[name] for name in NETWORK if name in os.environ}


def main():
    """Command line; exit code 1 when a number or a line does not hold."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ancf", required=True, help="the program")
    arguments = parser.parse_args()
    found, total = [], [0, 0, 0]
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        known = environment(folder, arguments.ancf)
        copy = folder / "repository"
        for name in COPIED:
            shutil.copytree(ROOT / name, copy / name, ignore=shutil.ignore_patterns("__pycache__", "target"))
        setup = [block for language, block in BLOCK.findall((FOLDER / "README.md").read_text(encoding="utf-8")) if language == "sh"]
        for command in setup:
            run(command, copy, known)
        total[0] += len(setup)
        known["PATH"] = f"{copy}/.venv/bin:{known['PATH']}"
        for sheet in sorted(FOLDER.glob("[0-9]*.md")):
            solution = FOLDER / "solutions" / sheet.name
            outputs = {}
            for path in (sheet, solution):
                text = path.read_text(encoding="utf-8")
                total = [a + b for a, b in zip(total, counts(text))]
                for task, part in tasks(text):
                    for language, block in BLOCK.findall(part):
                        if language == "sh":
                            outputs[task] = outputs.get(task, "") + run(block, copy, known)
            for path in (sheet, solution):
                for task, part in tasks(path.read_text(encoding="utf-8")):
                    found += faults(path.relative_to(FOLDER), task, part, outputs.get(task, ""))
    print(f"{total[0]} commands run, {total[1]} printed blocks and {total[2]} numbers compared: {len(found)} wrong")
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
