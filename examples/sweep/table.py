"""One line for each run: its parameters, how it ended, and what was found. Run by the Snakefile."""

import csv
import json
from pathlib import Path

# Part of the largest reach at which the structure counts as deployed.
DEPLOYED = 0.95


def found(folder):
    """When the structure is deployed, s, and the largest deflection of a rod, m."""
    with (folder / "trajectory.csv").open(newline="") as file:
        rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    reach = max(row["a4.x"] for row in rows)
    deployed = next(row["t"] for row in rows if row["a4.x"] >= DEPLOYED * reach)
    deflection = max(abs(value) for row in rows for key, value in row.items() if key.endswith(".w"))
    return {"deployed_after": round(deployed, 9), "largest_deflection": deflection}


def line(row):
    """The line of a run."""
    path = Path("runs") / f"{row['name']}.json"
    told = json.loads(path.read_text())
    ended = {"status": told["status"], "run": told.get("run", ""), "error": told.get("error", "")}
    return row | ended | (found(path.with_suffix("")) if told["status"] == "ok" else {})


with open(snakemake.config.get("parameters", "parameters.csv"), newline="") as file:
    lines = [line(row) for row in csv.DictReader(file)]
with open(snakemake.output[0], "w", newline="") as file:
    columns = dict.fromkeys(key for row in lines for key in row)
    writer = csv.DictWriter(file, [*columns])
    writer.writeheader()
    writer.writerows(lines)
