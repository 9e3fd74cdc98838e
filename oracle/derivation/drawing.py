"""Lines, arrows and words of a picture as SVG, in colours that read on white and on black."""

from xml.sax.saxutils import escape

# Each has a contrast of 3 at least on white and on GitHub's dark ground; `contrast` is asserted below.
COLOURS = {"line": "#7d8590", "first": "#3f88d8", "second": "#c8701e", "third": "#4f9a58"}
GROUNDS = ("#ffffff", "#0d1117")
LEAST = 3.0


def luminance(colour):
    """Relative luminance as WCAG defines it."""
    parts = [int(colour[k:k + 2], 16) / 255 for k in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    """Ratio of contrast of two colours."""
    high, low = sorted((luminance(a), luminance(b)), reverse=True)
    return (high + 0.05) / (low + 0.05)


assert all(contrast(colour, ground) >= LEAST for colour in COLOURS.values() for ground in GROUNDS)


class Drawing:
    """A picture of the given size in pixels. `origin` is where the point (0, 0) lies, `scale` the pixels of a unit; y points upwards."""

    def __init__(self, width, height, title):
        self.size, self.title, self.parts = (width, height), title, []
        self.place((0, 0), 1)

    def place(self, origin, scale):
        """Where what follows is drawn."""
        self.origin, self.scale = origin, scale

    def at(self, point):
        """Pixels of a point."""
        return self.origin[0] + self.scale * point[0], self.origin[1] - self.scale * point[1]

    def line(self, points, colour="line", width=1.5, dashed=False, closed=False):
        """A polyline."""
        text = " ".join(f"{x:.1f},{y:.1f}" for x, y in map(self.at, points))
        dash = ' stroke-dasharray="4 4"' if dashed else ""
        tag = "polygon" if closed else "polyline"
        self.parts.append(f'<{tag} points="{text}" fill="none" stroke="{COLOURS[colour]}" stroke-width="{width}"{dash}/>')

    def arrow(self, start, vector, colour="first", label="", offset=(6, -4)):
        """An arrow with its name at its head."""
        end = (start[0] + vector[0], start[1] + vector[1])
        (x1, y1), (x2, y2) = self.at(start), self.at(end)
        length = max(((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5, 1e-9)
        ux, uy = (x2 - x1) / length, (y2 - y1) / length
        head = [(x2, y2), (x2 - 9 * ux + 4 * uy, y2 - 9 * uy - 4 * ux), (x2 - 9 * ux - 4 * uy, y2 - 9 * uy + 4 * ux)]
        corners = " ".join(f"{x:.1f},{y:.1f}" for x, y in head)
        self.parts.append(f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2 - 6 * ux:.1f}" y2="{y2 - 6 * uy:.1f}" '
                          f'stroke="{COLOURS[colour]}" stroke-width="2"/>')
        self.parts.append(f'<polygon points="{corners}" fill="{COLOURS[colour]}"/>')
        if label:
            self.pixels((x2 + offset[0], y2 + offset[1]), label, colour)

    def dot(self, point, colour="second"):
        """A node."""
        x, y = self.at(point)
        self.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4.5" fill="{COLOURS[colour]}"/>')

    def words(self, point, text, colour="line", offset=(0, 0)):
        """Words at a point."""
        x, y = self.at(point)
        self.pixels((x + offset[0], y + offset[1]), text, colour)

    def pixels(self, place, text, colour):
        """Words at a place in pixels; `_` and `^` begin an index of one letter."""
        spans, k = "", 0
        while k < len(text):
            if text[k] in "_^" and k + 1 < len(text):
                shift = 4 if text[k] == "_" else -6
                spans += f'<tspan dy="{shift}" font-size="11">{escape(text[k + 1])}</tspan><tspan dy="{-shift}">\u200b</tspan>'
                k += 2
            else:
                spans += escape(text[k])
                k += 1
        self.parts.append(f'<text x="{place[0]:.1f}" y="{place[1]:.1f}" fill="{COLOURS[colour]}">{spans}</text>')

    def svg(self):
        """The file."""
        width, height = self.size
        head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" role="img" '
                f'font-family="sans-serif" font-size="15">\n<title>{escape(self.title)}</title>')
        return "\n".join([head, *self.parts, "</svg>"]) + "\n"
