"""`python -m oracle [FIXTURE|derivation|proofs] [--check]`: proofs, then fixtures and derivation, written or compared."""

import argparse
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from importlib import import_module

from . import contents
from .fixtures import fixture, schemas, versions
from .proofs import PROOFS

FIXTURES = ("equations", "cable", "pendulum", "structure", "continuum", "references", "invalid")
# Pages for readers; their formulas are asserted as the page is written.
PAGES = ("derivation",)
# Fixtures of a program that few have installed: generated only by name; otherwise only their `check` is run.
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
    """Runs every proof; a failed assertion ends the program."""
    for proof in PROOFS:
        start = time.perf_counter()
        sentence = proof()
        print(f"proved   {time.perf_counter() - start:6.1f} s  {sentence}", flush=True)


def module_of(name):
    """The module that generates a fixture or a page."""
    return import_module(f".{MODULES[name]}", __package__)


def derive(name, partly):
    """A fixture derived again, and the seconds taken; `partly` derives only what the module's `check` does, if it has one."""
    start = time.perf_counter()
    module = module_of(name)
    fresh = getattr(module, "check", module.generate)() if partly else module.generate()
    return fresh, time.perf_counter() - start


def compare(module, fresh):
    """Differences between the stored and the derived fixture, as lines that name file and place."""
    if hasattr(module, "faults"):
        return module.faults(fresh)
    try:
        stored = fixture.read(module.FILE)
        seal = stored.pop("sha256", None)
        faults = [] if seal == fixture.digest(stored) else ["sha256: does not match the content: the file was edited by hand"]
        faults += versions.faults(module.FILE, stored, fixture.render, fixture.FOLDER)
        faults += module.differences(stored, fresh)
    except (OSError, ValueError) as error:
        faults = [f"cannot be read: {error}"]
    return [f"fixtures/{module.FILE}: {fault}" for fault in faults]


def main():
    """Command line; exit code 1 when a stored file differs from the derived one."""
    parser = argparse.ArgumentParser(prog="python -m oracle", description=__doc__)
    parser.add_argument("only", nargs="?", choices=(*FIXTURES, *PAGES, *WITNESSES, "proofs"), help="this one only; without it, all")
    parser.add_argument("--check", action="store_true", help="compare and write nothing")
    arguments = parser.parse_args()
    names = {None: FIXTURES + PAGES + WITNESSES * arguments.check, "proofs": ()}.get(arguments.only, (arguments.only,))
    faults = []
    with ProcessPoolExecutor(max_workers=2) as pool:
        # Derivations run in their own processes from the start; nothing is written before all proofs hold.
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
                note = ", the part that a check derives" if partly and hasattr(module, "check") else ""
            else:
                if hasattr(module, "keep"):
                    fresh = module.keep(fixture.read(module.FILE), fresh)
                size = module.write(fresh) if name in PAGES else fixture.write(module.FILE, fresh)
                verb, note = "written", f", {size} bytes"
            place = module.NAME if name in PAGES else f"fixtures/{module.FILE}"
            print(f"{verb:8} {seconds:6.1f} s  {place}{note}", flush=True)
    if arguments.check and arguments.only is None:
        faults += schemas.faults()
        print(f"checked  {len(schemas.FILES)} files against their schemas", flush=True)
        faults += contents.faults()
        print(f"checked  {len(contents.modules())} modules against {contents.NAME}", flush=True)
    for fault in faults[:SHOWN]:
        print(fault, file=sys.stderr)
    if len(faults) > SHOWN:
        print(f"... and {len(faults) - SHOWN} more differences", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
