"""A scene file as a peer needs it, in plain floats: straight rods, supports, forces, heat along the rods.

`oracle/structure/scene.py` reads scenes as exact numbers and needs the libraries for them; this reader does not.
"""

import json
from dataclasses import dataclass
from math import dist, isclose
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "src" / "model" / "scenes"
SCHEMA = "ancf-scene/1"
KNOWN = {"schema", "title", "notes", "material", "section", "points", "rods", "supports", "gravity", "forces",
         "temperature", "time", "output", "probes"}
ROD = {"name", "from", "to", "elements", "pivot"}


@dataclass(frozen=True)
class Rod:
    """A straight rod between two named points; `pivot` names the pin at its middle, or is None."""

    ends: tuple[str, str]
    pivot: str | None


@dataclass(frozen=True)
class Scene:
    """A scene of `src/model/scenes` that a peer can run. SI units."""

    name: str
    points: dict[str, tuple[float, float]]
    rods: tuple[Rod, ...]
    fixed: tuple[tuple[str, tuple[int, ...]], ...]  # name of a point, held axes (x = 0, y = 1)
    forces: tuple[tuple[str, tuple[float, float]], ...]
    gravity: tuple[float, float]
    EA: float
    EI: float
    GA: float
    rho_A: float
    expansion: float
    history: tuple[tuple[float, float], ...]  # of the temperature, (s, K)
    relaxed: bool
    end: float
    probe: str

    def length(self, rod):
        """The rod's length at the reference temperature."""
        return dist(*(self.points[end] for end in rod.ends))

    def thermal_strain(self, t):
        """alpha dT at time t: linear between the entries of the history, constant outside them."""
        if not self.history:
            return 0.0
        before = [entry for entry in self.history if entry[0] <= t] or [self.history[0]]
        after = [entry for entry in self.history if entry[0] > t] or [self.history[-1]]
        (start, a), (end, b) = before[-1], after[0]
        dT = a + (b - a) * (t - start) / (end - start) if end > start else a
        return self.expansion * dT

    @property
    def is_heated_in_time(self):
        """Whether the temperature changes after t = 0."""
        return len({dT for _, dT in self.history}) > 1


def read(name):
    """The scene of that name; ValueError if it has a feature that a peer would silently leave out."""
    with open(FOLDER / f"{name}.json", encoding="utf-8") as file:
        scene = json.load(file)
    supports = scene.get("supports", [])
    for has, what in (
        (scene["schema"] == SCHEMA, "another schema"),
        (not set(scene) - KNOWN, f"unknown keys {sorted(set(scene) - KNOWN)}"),
        (all(set(force) == {"point", "force"} for force in scene.get("forces", [])), "a force with a history"),
        (all(set(rod) <= ROD for rod in scene["rods"]), "a rod of its own kind"),
        (all(set(support) == {"point", "fix"} for support in supports), "a support that is not a hinge"),
    ):
        if not has:
            raise ValueError(f"scene {name} has {what}, which the peers' reader does not support")
    material, section, heat = scene["material"], scene["section"], scene.get("temperature", {})
    h, w, E = section["height"], section["width"], material["E"]
    found = Scene(
        name=name,
        points={point: tuple(place) for point, place in scene["points"].items()},
        rods=tuple(Rod((rod["from"], rod["to"]), rod.get("pivot")) for rod in scene["rods"]),
        fixed=tuple((support["point"], tuple("xy".index(axis) for axis in support["fix"]))
                    for support in supports),
        forces=tuple((force["point"], tuple(force["force"])) for force in scene.get("forces", [])),
        gravity=tuple(scene.get("gravity", (0.0, 0.0))),
        EA=E * h * w,
        EI=E * w * h**3 / 12,
        GA=E * h * w / (2 * (1 + material["nu"])),  # without a shear correction, as the paper's element
        rho_A=material["rho"] * h * w,
        expansion=material.get("alpha", 0.0),
        history=tuple(map(tuple, heat.get("history", []))),
        relaxed=heat.get("start") == "relaxed",
        end=scene["time"]["end"],
        probe=next(probe["point"] for probe in scene["probes"] if "point" in probe),
    )
    if found.relaxed and (len(found.rods) != 1 or found.is_heated_in_time):
        raise ValueError(f"scene {name}: a relaxed start is that of a single rod at one temperature")
    for rod in found.rods:
        if not isclose(found.length(rod), found.length(found.rods[0])):
            raise ValueError(f"scene {name}: the peers' grid counts elements of rods of one length")
    return found
