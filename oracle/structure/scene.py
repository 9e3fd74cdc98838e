"""A scene file read exactly: rods and their coordinates in q, forces, supports and heat.

The numbers of a scene are decimals, hence rational. Only the keys in the scenes of `scenes.py` are read. These scenes
leave nothing out, so that no defaults are needed.
"""

from fractions import Fraction
from itertools import pairwise
from math import isqrt

from flint import fmpq

from ..fixtures.fixture import each


def exact(numbers):
    """Nested lists of decimals as rational numbers."""

    def rational(number):
        value = Fraction(str(number))
        return fmpq(value.numerator, value.denominator)

    return each(rational, numbers)


def direction(vector):
    """Unit vector and length of a rational vector whose length is rational."""
    square = sum(c * c for c in vector)
    length = fmpq(isqrt(int(square.p)), isqrt(int(square.q)))
    assert length**2 == square, f"the length of {vector} is not rational"
    return [c / length for c in vector], length


def piecewise(history, t):
    """Value of a history at time t: linear between its entries, constant outside."""
    if t <= history[0][0]:
        return history[0][1]
    for (start, a), (end, b) in pairwise(history):
        if t <= end:
            return a + (b - a) * (t - start) / (end - start)
    return history[-1][1]


class Rod:
    """One rod. `first` is the index of its first nodal vector in the structure."""

    def __init__(self, scene, entry, first):
        own = {key: entry.get(key, scene.get(key)) for key in ("material", "section", "temperature")}
        self.name, self.elements, self.first = entry["name"], entry["elements"], first
        self.start, self.end = (exact(scene["points"][entry[key]]) for key in ("from", "to"))
        self.t, self.L = direction([b - a for a, b in zip(self.start, self.end)])
        self.n = [-self.t[1], self.t[0]]
        self.l = self.L / self.elements
        self.E, self.nu, self.rho, self.alpha = (
            exact(own["material"][key]) for key in ("E", "nu", "rho", "alpha"))
        self.h, self.w = (exact(own["section"][key]) for key in ("height", "width"))
        heat = own["temperature"]
        self.model, self.history = heat["model"], exact(heat["history"])
        self.vectors = 5 * self.elements + 2  # neighbours share r and r_y at their common node
        middle = 5 * (self.elements // 2)
        odd = self.elements % 2 == 1
        # Indices of r and r_y at both ends and, for a pivot, at the middle: node j of (4) in the middle element, or the
        # node between two elements.
        self.nodes = {entry["from"]: (0, 1), entry["to"]: (5 * self.elements, 5 * self.elements + 1)}
        if "pivot" in entry:
            self.nodes[entry["pivot"]] = (middle + 2, middle + 4) if odd else (middle, middle + 1)

    def straight(self):
        """Initial nodal vectors: straight and unstrained."""

        def at(k):
            """The axis point at a distance of k half elements from the start."""
            return [a + c * self.l * k / 2 for a, c in zip(self.start, self.t)]

        vectors = [at(0), self.n]
        for k in range(self.elements):
            vectors += [at(2 * k + 1), self.t, self.n, at(2 * k + 2), self.n]
        return [component for vector in vectors for component in vector]


class Scene:
    """The structure of a scene file."""

    def __init__(self, document):
        self.document, self.rods, first = document, [], 0
        for entry in document["rods"]:
            self.rods.append(Rod(document, entry, first))
            first += self.rods[-1].vectors
        self.size = 2 * first
        self.gravity = exact(document["gravity"])
        # For each point: the rods that have it with the indices of r and r_y there, and its initial place.
        self.points = {}
        for rod in self.rods:
            for point, node in rod.nodes.items():
                self.points.setdefault(point, []).append((rod, *(rod.first + k for k in node)))
        initial = self.straight()
        self.places = {
            point: initial[2 * meeting[0][1]:2 * meeting[0][1] + 2] for point, meeting in self.points.items()
        }
        self.forces = [
            (force["point"], exact(force["force"]), exact(force["history"])) for force in document["forces"]
        ]

    def straight(self):
        """Initial q, rod by rod."""
        return [component for rod in self.rods for component in rod.straight()]
