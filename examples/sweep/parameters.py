"""Prints a table of runs: three scissors, other angles and forces; every eighth is bad on purpose, to see failures recorded.

    python parameters.py 20 > parameters.csv
"""

import csv
import sys

FORCES = (40, 60, 80, 100)
COARSE = "--set 'rods.*.elements=4' --set time.step=1e-3"
BAD = (
    # Refused: a value that is not allowed, an unknown key, an unknown method.
    "--set material.E=-1", "--set time.stepp=1", "--set time.method=euler",
    # Fails: steps too long for this motion.
    "--set time.step=0.25",
)


def options(angle, force):
    """What `ancf run` is told."""
    return f"scissors-3-thermal --angle {angle} --force {force} {COARSE}"


def main():
    """Writes the table."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 20
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["name", "angle", "force", "options"])
    angles = -(-count // len(FORCES))
    for n in range(count):
        angle, force = 74 + 8 * (n // len(FORCES)) / max(angles - 1, 1), FORCES[n % len(FORCES)]
        bad = f" {BAD[n // 8 % len(BAD)]}" if n % 8 == 7 else ""
        writer.writerow([f"run-{n:03}", f"{angle:.3f}", force, options(f"{angle:.3f}", force) + bad])


if __name__ == "__main__":
    main()
