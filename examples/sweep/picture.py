"""Deployment time and largest deflection over the angle at the start, a line for each force. Run by the Snakefile."""

import csv

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

with open(snakemake.input[0], newline="") as file:
    rows = [row for row in csv.DictReader(file) if row["status"] == "ok"]
figure, panels = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
for panel, (column, label) in zip(panels, [("deployed_after", "deployed after, s"), ("largest_deflection", "largest deflection, m")]):
    for force in sorted({row["force"] for row in rows}, key=float):
        curve = sorted((float(row["angle"]), float(row[column])) for row in rows if row["force"] == force)
        panel.plot(*zip(*curve), marker="o", label=f"{force} N")
    panel.set(xlabel="angle at the start, degrees", ylabel=label)
panels[0].legend(frameon=False)
figure.savefig(snakemake.output[0])
