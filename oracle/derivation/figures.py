"""Pictures of the page, computed from the shape functions and from the energy density."""

from math import cos, pi, sin

import sympy

from ..element import field
from .drawing import Drawing
from .force import frame
from .material import E, nu

HEIGHT, LENGTH = 0.3, 1.0
ENDS, FINE = (-HEIGHT / 2, HEIGHT / 2), [k / 40 for k in range(41)]
SHAPES = [sympy.lambdify((field.x, field.y), shape.subs(field.l, 1)) for shape in field.shape_functions()]
# Nodal vectors of a bent, sheared and stretched element, in the order of (4).
BENT = ((0.0, 0.0), (-0.35, 1.0), (0.52, 0.2), (1.05, 0.1), (-0.1, 1.15), (1.05, 0.05), (0.35, 1.0))


def position(x, y):
    """A point of the bent element."""
    values = [shape(x, y) for shape in SHAPES]
    return tuple(sum(value * node[i] for value, node in zip(values, BENT)) for i in range(2))


def slope(x, y, name):
    """A slope of the bent element; the position is a polynomial of degree three, for which this difference is exact."""
    def along(step):
        ahead, behind = (position(x + s, y) if name == "x" else position(x, y + s) for s in (step, -step))
        return [(a - b) / (2 * step) for a, b in zip(ahead, behind)]

    return tuple((4 * a - b) / 3 for a, b in zip(along(0.1), along(0.2)))


def outline(place):
    """The four sides of an element whose points are at `place`."""
    down, up = ENDS
    return ([place(x, down) for x in FINE] + [place(x, up) for x in reversed(FINE)])


def straight(x, y):
    """A point of the element at the start."""
    return x, y


def element():
    """The element in its own coordinates, and deformed."""
    drawing = Drawing(760, 230, "The element in its own coordinates, and deformed, with its nodes and nodal vectors")
    drawing.place((50, 140), 270)
    drawing.line(outline(straight), closed=True)
    drawing.arrow((0, 0), (1.13, 0), "line", "x")
    drawing.arrow((0, 0), (0, 0.3), "line", "y")
    for x, name in ((0, "i"), (0.5, "j"), (1, "k")):
        drawing.dot((x, 0))
        drawing.words((x, 0), name, "second", (-4, 22))
    drawing.words((0, -0.15), "0", offset=(-4, 18))
    drawing.words((1, -0.15), "l", offset=(-4, 18))
    drawing.words((0, 0.15), "h/2", offset=(-32, 4))
    drawing.words((0, -0.15), "−h/2", offset=(-42, 4))
    drawing.place((430, 165), 270)
    drawing.line(outline(position), closed=True)
    drawing.line([position(x, 0) for x in FINE], dashed=True)
    for x, name in ((0, "i"), (0.5, "j"), (1, "k")):
        drawing.arrow(position(x, 0), [0.2 * part for part in slope(x, 0, "y")], "first", f"r_y^{name}")
    drawing.arrow(position(0.5, 0), [0.2 * part for part in slope(0.5, 0, "x")], "third", "r_x^j", (4, 16))
    for x, name in ((0, "i"), (0.5, "j"), (1, "k")):
        drawing.dot(position(x, 0))
        drawing.words(position(x, 0), f"r^{name}", "second", (-8, 24))
    return drawing


def shapes():
    """The shape functions on the axis, and of slopes across over the place across."""
    drawing = Drawing(760, 210, "Shape functions of positions and of the slope along, and of the slopes across")
    for left, numbers, factor in ((40, (1, 3, 6, 4), None), (420, (2, 5, 7), 1.0)):
        drawing.place((left, 130), 110)
        drawing.line([(0, 0), (2.6, 0)], width=1)
        drawing.line([(0, -0.5), (0, 1.1)], width=1)
        for number, colour in zip(numbers, ("first", "second", "third", "line")):
            values = [SHAPES[number - 1](x, factor or 0) for x in FINE]
            drawing.line([(2.5 * x, value) for x, value in zip(FINE, values)], colour, 2)
            top = max(range(41), key=lambda k: abs(values[k]))
            over = " / y" if factor else " / l" if number == 4 else ""
            drawing.words((2.5 * FINE[top], values[top]), f"S_{number}{over}", colour, (8, -4))
        drawing.words((2.5, 0), "ξ = 1", offset=(-10, 18))
    return drawing


def slopes():
    """Fibres along and across at one point."""
    drawing = Drawing(760, 250, "Fibres of the deformed element, and the slopes at one point")
    drawing.place((180, 180), 380)
    for k in range(11):
        drawing.line([position(k / 10, y) for y in ENDS], width=1)
    for k in range(5):
        drawing.line([position(x, -0.15 + 0.075 * k) for x in FINE], width=1)
    place = position(0.3, 0.0)
    drawing.arrow(place, [0.25 * part for part in slope(0.3, 0, "x")], "third", "r_x")
    drawing.arrow(place, [0.25 * part for part in slope(0.3, 0, "y")], "first", "r_y")
    drawing.dot(place)
    return drawing


def deformation():
    """A fibre before and now."""
    drawing = Drawing(760, 230, "A short fibre of the element at the start, and the same fibre now")
    drawing.place((50, 150), 270)
    drawing.line(outline(straight), closed=True)
    start, fibre = (0.3, -0.03), (0.16, 0.1)
    drawing.arrow(start, fibre, "second", "dr_0")
    drawing.arrow((1.07, 0.05), (0.2, 0), "line", "J")
    drawing.place((440, 165), 270)
    drawing.line(outline(position), closed=True)
    along, across = slope(*start, "x"), slope(*start, "y")
    moved = [along[i] * fibre[0] + across[i] * fibre[1] for i in range(2)]
    drawing.arrow(position(*start), moved, "second", "dr = J dr_0")
    return drawing


def turned_frame():
    """The energy density of one strain, described from a turned frame, over its true value."""
    drawing = Drawing(760, 260, "Energy density of a stretched rod from a turned frame: right, and as printed")
    drawing.place((130, 130), 100)
    drawing.line([(-0.9, -0.18), (0.9, -0.18), (0.9, 0.18), (-0.9, 0.18)], closed=True)
    angle = pi / 6
    for vector, colour, label in (((1.1, 0), "line", "t"), ((0, 1.1), "line", "n")):
        drawing.arrow((0, 0), vector, colour, label)
    for vector, label in (((1.1 * cos(angle), 1.1 * sin(angle)), "1"), ((-1.1 * sin(angle), 1.1 * cos(angle)), "2")):
        drawing.arrow((0, 0), vector, "first", label)
    drawing.line([(0.5 * cos(angle * k / 10), 0.5 * sin(angle * k / 10)) for k in range(11)], "first")
    drawing.words((0.5, 0.12), "φ", "first", (6, 0))
    turn, own, density = frame()
    stretched = dict(zip(own, (1, 0, 0)))
    right, printed = (sympy.lambdify(turn, density(weight).subs(stretched).subs(nu.meaning, 0).subs(E.meaning, 1)) for weight in (4, 2))
    drawing.place((340, 220), 1)
    drawing.line([(0, 0), (380, 0)], width=1)
    drawing.line([(0, 0), (0, 200)], width=1)
    for value in (0.75, 1.0):
        drawing.line([(0, 600 * (value - 0.7)), (380, 600 * (value - 0.7))], width=1, dashed=True)
        drawing.words((0, 600 * (value - 0.7)), f"{value:g}", offset=(-34, 5))
    for function, colour, label, down in ((right, "third", "right", -8), (printed, "second", "as printed", 18)):
        points = [(k, 600 * (function(pi * k / 380) / right(0) - 0.7)) for k in range(0, 381, 4)]
        drawing.line(points, colour, 2.5)
        drawing.words(points[24], label, colour, (-34, down))
    for part, label in ((0, "φ = 0"), (190, "90°"), (380, "180°")):
        drawing.words((part, 0), label, offset=(-14, 20))
    return drawing


FIGURES = {"element": element, "shapes": shapes, "slopes": slopes, "deformation": deformation, "frame": turned_frame}


def texts():
    """The files, by name."""
    return {f"{name}.svg": make().svg() for name, make in FIGURES.items()}
