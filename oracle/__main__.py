"""`python -m oracle [FIXTURE|derivation|proofs] [--check]`: prove, then write or compare fixtures and derivation, or one."""

import argparse
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from importlib import import_module

from .fixtures import fixture, schemas, versions
from .proofs import PROOFS

FIXTURES = ("equations", "cable", "pendulum", "structure", "continuum", "references", "invalid")
# Pages for readers; their formulas are asserted as the page is written.
PAGES = ("derivation",)
# Fixtures of a program that few have installed: run only when named; otherwise checked as far as their `check` goes.
WITNESSES = ("calculix",)
# Module that generates and compares each of them.
MODULES = {
    "equations": "element.equations",
    "cable": "cable.equations",
    "pendulum": "motion.pendulum",
    "structure": "structure.structure",
    "continuum": "solid.continuum",
    "references": "references.collection",
    "invalid": "element.invalid_states",
    "derivation": "derivation",
    "calculix": "solid.calculix",
}
SHOWN = 10


def prove():
    """Runs every proof; an assertion that fails ends the program."""
    for proof in PROOFS:
        start = time.perf_counter()
        sentence = proof()
        print(f"proved   {time.perf_counter() - start:6.1f} s  {sentence}", flush=True)


def module_of(name):
    """The module that generates a fixture or a page."""
    return import_module(f".{MODULES[name]}", __package__)


def derive(name, partly):
    """One fixture derived afresh, and the seconds that it took; `partly`: only what its `check` derives, if it has one."""
    start = time.perf_counter()
    module = module_of(name)
    fresh = getattr(module, "check", module.generate)() if partly else module.generate()
    return fresh, time.perf_counter() - start


def compare(module, fresh):
    """Where what is stored differs from what is derived, as lines that name file and place."""
    if hasattr(module, "faults"):
        return module.faults(fresh)
    try:
        stored = fixture.read(module.FILE)
        seal = stored.pop("sha256", None)
        faults = [] if seal == fixture.digest(stored) else ["sha256: not that of the content, which was edited by hand"]
        faults += versions.faults(module.FILE, stored, fixture.render, fixture.FOLDER)
        faults += module.differences(stored, fresh)
    except (OSError, ValueError) as error:
        faults = [f"cannot be read: {error}"]
    return [f"fixtures/{module.FILE}: {fault}" for fault in faults]


def main():
    """The command line; exit code 1 when what is stored differs from what is derived."""
    parser = argparse.ArgumentParser(prog="python -m oracle", description=__doc__)
    parser.add_argument("only", nargs="?", choices=(*FIXTURES, *PAGES, *WITNESSES, "proofs"), help="everything without it")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    arguments = parser.parse_args()
    names = {None: FIXTURES + PAGES + WITNESSES * arguments.check, "proofs": ()}.get(arguments.only, (arguments.only,))
    faults = []
    with ProcessPoolExecutor(max_workers=2) as pool:
        # Deriving starts at once, on its own cores; nothing is written before the proofs hold.
        partly = arguments.check and arguments.only not in WITNESSES
        derivations = {name: pool.submit(derive, name, partly) for name in names}
        prove()
        for name, derivation in derivations.items():
            module = module_of(name)
            fresh, seconds = derivation.result()
            if arguments.check:
                found = compare(module, fresh)
                faults += found
                verb = "differs" if found else "agrees"
                note = ", as far as a check derives it" if partly and hasattr(module, "check") else ""
            else:
                size = module.write(fresh) if name in PAGES else fixture.write(module.FILE, fresh)
                verb, note = "written", f", {size} bytes"
            place = module.NAME if name in PAGES else f"fixtures/{module.FILE}"
            print(f"{verb:8} {seconds:6.1f} s  {place}{note}", flush=True)
    if arguments.check and arguments.only is None:
        faults += schemas.faults()
        print(f"checked  {len(schemas.FILES)} files against their schemas", flush=True)
    for fault in faults[:SHOWN]:
        print(fault, file=sys.stderr)
    if len(faults) > SHOWN:
        print(f"... and {len(faults) - SHOWN} more differences", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
