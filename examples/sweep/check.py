"""Tries the sweep in a folder of its own: bad runs are recorded, a rerun does nothing, one changed scene makes one run.

    python check.py 20 --ancf ../../target/release/ancf
"""

import argparse
import csv
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).parent
FILES = ("Snakefile", "parameters.py", "picture.py", "table.py", "slurm")


def snakemake(folder, *arguments):
    """What Snakemake says."""
    command = [str(Path(sys.executable).with_name("snakemake")), *arguments]
    # Its files belong into the folder, too.
    environment = os.environ | {"XDG_CACHE_HOME": str(folder / ".cache"), "HOME": str(folder)}
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"snakemake {' '.join(arguments)} failed:\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def sweep(folder, ancf, *arguments):
    """Runs the sweep and returns when each run's line was written."""
    said = snakemake(folder, "--cores", "2", "--config", f"ancf={ancf}", *arguments)
    return said, {path.stem: path.stat().st_mtime_ns for path in (folder / "runs").glob("*.json")}


def check(folder, count, ancf):
    """The whole of it."""
    parameters = folder / "parameters.csv"
    parameters.write_text(subprocess.run([sys.executable, "parameters.py", str(count)], cwd=folder, capture_output=True, text=True, check=True).stdout)
    _, first = sweep(folder, ancf)
    with (folder / "results.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    bad = [row for n, row in enumerate(rows) if n % 8 == 7]
    good = [row for row in rows if row not in bad]
    assert len(rows) == len(first) == count, f"{len(rows)} rows, {len(first)} runs"
    assert all(row["status"] in ("failed", "refused") and row["error"] for row in bad), "a bad run is not recorded"
    assert all(row["status"] == "ok" and float(row["deployed_after"]) > 0.5 for row in good), "a good run is not there"
    assert (folder / "results.svg").read_text().count("<path") > 10, "no picture"
    said, again = sweep(folder, ancf)
    assert "Nothing to be done" in said and again == first, "a rerun does something"
    parameters.write_text(parameters.read_text().replace("--angle 74.000", "--angle 74.500", 1))
    _, changed = sweep(folder, ancf)
    assert [name for name in first if changed[name] != first[name]] == ["run-000"], "one changed scene does not make one run"
    print(f"{count} runs, {len(bad)} of them bad and recorded; a rerun made none, a changed scene one")
    # The queue itself is not here: what would be sent is planned.
    shutil.rmtree(folder / "runs")
    try:
        import snakemake_executor_plugin_slurm  # noqa: F401
    except ImportError:
        print("SKIPPED: no Slurm executor plugin")
        return
    assert f"{count}" in snakemake(folder, "--profile", "slurm", "--dry-run", "--config", f"ancf={ancf}"), "no plan for a cluster"
    print("the plan for a cluster is made")


def main():
    """Reads the options."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("count", type=int, nargs="?", default=20)
    parser.add_argument("--ancf", default="ancf", help="the program [default: ancf]")
    options = parser.parse_args()
    found = shutil.which(options.ancf)
    if not found:
        raise SystemExit(f"no program {options.ancf}: build it with `cargo build --release`")
    with tempfile.TemporaryDirectory() as folder:
        for name in FILES:
            (shutil.copytree if (HERE / name).is_dir() else shutil.copy)(HERE / name, Path(folder) / name)
        check(Path(folder), options.count, str(Path(found).resolve()))


if __name__ == "__main__":
    main()
