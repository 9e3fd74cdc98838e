"""Prints a table of runs: three scissors, other angles and heats; every eighth is bad on purpose, to see failures recorded.

    python parameters.py 20 > parameters.csv
"""

import csv
import sys

HEATS = (0, 50, 100, 150)
COARSE = "--set 'rods.*.elements=4' --set time.step=1e-3"
BAD = (
    # Refused: a value that is not allowed, an unknown key, an unknown method.
    "--set material.E=-1", "--set time.stepp=1", "--set time.method=euler",
    # Fails: steps too long for this motion.
    "--set time.step=0.25",
)


def options(angle, heat):
    """What `ancf run` is told."""
    history = [[0, 0], [0.25, heat], [1.25, heat], [1.75, -heat], [2.75, -heat], [3, 0]]
    return f"scissors-3-thermal --angle {angle} {COARSE} --set 'temperature.history={history}'".replace(", ", ",")


def main():
    """Writes the table."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["name", "angle", "heat", "options"])
    angles = -(-count // len(HEATS))
    for n in range(count):
        angle, heat = 70 + 12 * (n // len(HEATS)) / max(angles - 1, 1), HEATS[n % len(HEATS)]
        bad = f" {BAD[n // 8 % len(BAD)]}" if n % 8 == 7 else ""
        writer.writerow([f"run-{n:03}", f"{angle:.3f}", heat, options(f"{angle:.3f}", heat) + bad])


if __name__ == "__main__":
    main()
