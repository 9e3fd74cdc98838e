"""The constraint functions Phi(q) of (23): pins and supports as functions of q.

q holds numbers, or the variables of a polynomial ring. The matrix Phi_q is the derivative of the functions in such a
ring.
"""

from dataclasses import dataclass

from flint import fmpq_mpoly_ctx

from .scene import Rod, direction, exact

AXES = ("x", "y")


def vector(q, k):
    """The nodal vector with index k in q."""
    return q[2 * k:2 * k + 2]


def dot(a, b):
    """Scalar product. Numbers belong in `a`: a ring's variables must be on the right."""
    return sum(u * v for u, v in zip(a, b))


@dataclass(frozen=True)
class Pin:
    """A pin: two rods meet at a point."""

    point: str
    rods: tuple
    vectors: tuple

    def value(self, q):
        """r of the second rod minus r of the first."""
        first, second = (vector(q, k) for k in self.vectors)
        return [b - a for a, b in zip(first, second)]

    def rows(self):
        """Description of each row."""
        return [f"pin {self.point}: {self.rods[1].name} - {self.rods[0].name}, {axis}" for axis in AXES]


@dataclass(frozen=True)
class Fix:
    """A support that holds a point in x or in y."""

    point: str
    vector: int
    axis: str
    place: list

    def value(self, q):
        """The component of r - r_0."""
        i = AXES.index(self.axis)
        return [vector(q, self.vector)[i] - self.place[i]]

    def rows(self):
        """Description of the row."""
        return [f"fix {self.point}: {self.axis}"]


@dataclass(frozen=True)
class Slide:
    """A slide: a point moves only along a direction."""

    point: str
    vector: int
    normal: list
    place: list

    def value(self, q):
        """n . (r - r_0)."""
        return [dot(self.normal, [c - c_0 for c, c_0 in zip(vector(q, self.vector), self.place)])]

    def rows(self):
        """Description of the row."""
        return [f"slide {self.point}: across"]


@dataclass(frozen=True)
class Clamp:
    """A clamp: the section of a rod keeps its direction at a point; its thickness is free."""

    point: str
    rod: Rod
    vector: int

    def value(self, q):
        """t_0 . r_y, with t_0 the rod's initial direction."""
        return [dot(self.rod.t, vector(q, self.vector))]

    def rows(self):
        """Description of the row."""
        return [f"clamp {self.point}: {self.rod.name}"]


def constraints(scene):
    """All constraints of a scene in the order of their rows: pins by point, then supports in the scene's order."""
    found = []
    for point in sorted(scene.points):
        meeting = scene.points[point]
        for (first, a, _), (second, b, _) in zip(meeting, meeting[1:]):
            found.append(Pin(point, (first, second), (a, b)))
    for support in scene.document["supports"]:
        point = support["point"]
        place, (_, r, _) = scene.places[point], scene.points[point][0]
        found += [Fix(point, r, axis, place) for axis in support.get("fix", ())]
        if "slide" in support:
            (c_x, c_y), _ = direction(exact(support["slide"]))
            found.append(Slide(point, r, [-c_y, c_x], place))
        if "clamp" in support:
            held = next(entry for entry in scene.points[point] if entry[0].name == support["clamp"])
            found.append(Clamp(point, held[0], held[2]))
    return found


def values(scene, q):
    """Phi(q)."""
    return [entry for constraint in constraints(scene) for entry in constraint.value(q)]


def derivative(scene):
    """Phi_q by differentiation. Its entries must be numbers: the constraints are linear in q."""
    names = [f"q{i}" for i in range(scene.size)]
    ring = fmpq_mpoly_ctx.get(names)
    rows = [[phi.derivative(name) for name in names] for phi in values(scene, list(ring.gens()))]
    assert all(entry.is_constant() for row in rows for entry in row)
    return [[entry(*[0] * scene.size) for entry in row] for row in rows]
