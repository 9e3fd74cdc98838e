"""A scene file read exactly: rods and their coordinates in q, what acts on them, and heat.

The numbers of a scene are the decimals as written, hence rational. Only the keys that the scenes of
`scenes.py` use are read; each of those scenes says everything, so no default is needed here.
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
    """The unit vector of a rational vector whose length is rational, and that length."""
    square = sum(c * c for c in vector)
    length = fmpq(isqrt(int(square.p)), isqrt(int(square.q)))
    assert length**2 == square, f"the length of {vector} is not rational"
    return [c / length for c in vector], length


def piecewise(history, t):
    """A history at time t: linear between its entries, constant outside them."""
    if t <= history[0][0]:
        return history[0][1]
    for (start, a), (end, b) in pairwise(history):
        if t <= end:
            return a + (b - a) * (t - start) / (end - start)
    return history[-1][1]


class Rod:
    """One rod. `first` is the number of its first nodal vector among those of the whole structure."""

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
        # The vectors r and r_y at the two ends and, if other rods are pinned there, at the middle: that
        # is the node j of (4) inside an element, or the node between two.
        self.nodes = {entry["from"]: (0, 1), entry["to"]: (5 * self.elements, 5 * self.elements + 1)}
        if "pivot" in entry:
            self.nodes[entry["pivot"]] = (middle + 2, middle + 4) if odd else (middle, middle + 1)

    def straight(self):
        """The rod's nodal vectors at first: on its line, without strain."""

        def at(k):
            """The axis point k half elements from the start."""
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
        # Which rods have a point, with the numbers of r and r_y there; and where the point is at first.
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
        """q at first, rod by rod."""
        return [component for rod in self.rods for component in rod.straight()]
