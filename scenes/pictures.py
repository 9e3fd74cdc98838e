"""Runs the scenes of this folder, and draws each as SVG: the start dashed, then the structure at some times or loads, darker as they go on.

    python3 scenes/pictures.py PROGRAM [--check]

PROGRAM is `ancf`. `--check` compares with the pictures that are there, and writes nothing. Needs Python 3.11 and nothing else.
"""

import argparse
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

FOLDER = Path(__file__).parent
WIDTH, MARGIN, LEGEND = 720, 40, 30
#: Pictures of the structure, the start counted.
STATES = 6
#: Displacements below this part of the structure's size are magnified, to as much as that.
SMALL, SEEN = 0.04, 0.15
#: Another machine rounds otherwise; so much may a line be off, in pixels.
AGREES = 1.0
STYLE = ("path{fill:none;stroke:#0b5cad;stroke-width:2.5}.start{stroke:#888;stroke-width:1.5;stroke-dasharray:4 4}circle{fill:#444}"
         "text{font:14px system-ui,sans-serif;fill:#444}@media(prefers-color-scheme:dark){path{stroke:#6db3f2}text{fill:#ccc}circle{fill:#ccc}}")
NUMBER = re.compile(r"-?\d+\.\d+")

Shape = list[tuple[float, float]]


def states(shapes: dict) -> list[list[Shape]]:
    """The axes of all rods in some states, from the first to the last."""
    last = len(shapes["t"]) - 1
    chosen = sorted({round(k * last / (STATES - 1)) for k in range(STATES)})
    return [[list(zip(rod["x"][k], rod["y"][k])) for rod in shapes["rods"]] for k in chosen]


def magnification(drawn: list[list[Shape]]) -> int:
    """Factor of the displacements: 1, 2 or 5 times a power of ten."""
    start = drawn[0]
    xs, ys = zip(*(point for rod in start for point in rod))
    size = max(max(xs) - min(xs), max(ys) - min(ys))
    moved = max(math.dist(a, b) for rods in drawn for rod, first in zip(rods, start) for a, b in zip(rod, first))
    if moved == 0 or moved > SMALL * size:
        return 1
    factor = SEEN * size / moved
    power = 10 ** math.floor(math.log10(factor))
    return max(1, power * max(step for step in (1, 2, 5) if step * power <= factor))


def picture(scene: dict, shapes: dict) -> str:
    """The picture as SVG."""
    drawn = states(shapes)
    factor = magnification(drawn)
    start = drawn[0]
    drawn = [[[(p + factor * (x - p), q + factor * (y - q)) for (x, y), (p, q) in zip(rod, first)] for rod, first in zip(rods, start)]
             for rods in drawn]
    xs, ys = zip(*(point for rods in drawn for rod in rods for point in rod))
    scale = (WIDTH - 2 * MARGIN) / max(max(xs) - min(xs), max(ys) - min(ys))
    height = scale * (max(ys) - min(ys)) + 2 * MARGIN + LEGEND

    def place(point) -> str:
        return f"{MARGIN + scale * (point[0] - min(xs)):.1f} {MARGIN + scale * (max(ys) - point[1]):.1f}"

    lines = []
    for k, rods in enumerate(drawn):
        marks = 'class="start"' if k == 0 else f'opacity="{0.2 + 0.8 * k / (len(drawn) - 1):.2f}"'
        lines += [f'<path {marks} d="M{" ".join(map(place, rod))}"/>' for rod in rods]
    for support in scene["supports"]:
        x, y = place(scene["points"][support["point"]]).split()
        lines.append(f'<circle cx="{x}" cy="{y}" r="4.5"/>')
    is_static = scene["time"].get("method") == "static"
    legend = f"dashed: the start; darker: {'more load' if is_static else 'later'}" + (f"; displacements × {factor}" if factor != 1 else "")
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height:.1f}" role="img" aria-label="{scene["title"]}">\n<style>{STYLE}</style>\n'
            + "\n".join(lines) + f'\n<text x="{MARGIN}" y="{height - 12:.1f}">{legend}</text>\n</svg>\n')


def agree(one: str, other: str) -> bool:
    """Whether two pictures differ by roundings at most."""
    numbers = [[float(number) for number in NUMBER.findall(text)] for text in (one, other)]
    return NUMBER.sub("", one) == NUMBER.sub("", other) and all(abs(a - b) <= AGREES for a, b in zip(*numbers))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=Path, help="the program ancf")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    arguments = parser.parse_args()
    wrong = []
    for file in sorted(FOLDER.glob("*.json")):
        with tempfile.TemporaryDirectory() as out:
            subprocess.run([arguments.program.resolve(), "run", file, "--no-report", "--out", out], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            shapes = json.loads((Path(out) / "shapes.json").read_text(encoding="utf-8"))
        drawn = picture(json.loads(file.read_text(encoding="utf-8")), shapes)
        target = file.with_suffix(".svg")
        if not arguments.check:
            target.write_text(drawn, encoding="utf-8")
        elif not target.exists() or not agree(target.read_text(encoding="utf-8"), drawn):
            wrong.append(target.name)
        print(f"{file.name}: {len(drawn)} bytes")
    if wrong:
        sys.exit(f"{', '.join(wrong)}: not what the scenes are; run python3 scenes/pictures.py, and look at them")


if __name__ == "__main__":
    main()
