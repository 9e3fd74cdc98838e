"""Settings of Sphinx for the book. `docs/book` puts the pages together (pages.py) and calls it."""

import json
import os
import subprocess
from pathlib import Path

from docutils import nodes
from sphinx.errors import SphinxError

KATEX = Path(os.environ["BOOK_KATEX"]) / "node_modules" / "katex"

project = "ancf"
version = release = os.environ["BOOK_VERSION"]
project_copyright = "the authors of ancf; MIT or Apache-2.0, the fixtures CC0"
extensions = ["myst_parser"]
# Anchors of headings as GitHub makes them, so that a link is right in both places.
myst_heading_anchors = 4
# Pieces of JSON that leave something out are no JSON to the highlighter.
suppress_warnings = ["misc.highlighting_failure"]
html_theme = "furo"
html_title = "ancf"
html_static_path = [str(Path(__file__).parent / "static"), str(KATEX.parents[1] / "css")]
html_css_files = ["katex.min.css", "book.css"]
# Browsers ask for an icon; without one that is a fault on their console.
html_favicon = str(Path(__file__).parent / "static/icon.svg")
html_copy_source = False
html_show_sphinx = False
html_math_renderer = "katex"
# Colours of code with the contrast that small text needs.
pygments_style, pygments_dark_style = "a11y-high-contrast-light", "a11y-high-contrast-dark"


class Typesetter:
    """KaTeX in a process of its own: formulas are HTML before anybody opens the page."""

    def __init__(self) -> None:
        self.process = subprocess.Popen(["node", Path(__file__).with_name("katex.mjs"), KATEX], stdin=subprocess.PIPE,
                                        stdout=subprocess.PIPE, text=True, encoding="utf-8")

    def html(self, tex: str, display: bool) -> str:
        self.process.stdin.write(json.dumps({"tex": tex, "display": display}) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            raise SphinxError(f"KaTeX does not read {tex!r}: {answer['error']}")
        return answer["html"]


def setup(app) -> None:
    typesetter = Typesetter()

    def inline(writer, node) -> None:
        writer.body.append(typesetter.html(node.astext(), display=False))
        raise nodes.SkipNode

    def block(writer, node) -> None:
        writer.body.append(f'<div class="formula" tabindex="0">{typesetter.html(node.astext(), display=True)}</div>')
        raise nodes.SkipNode

    app.add_html_math_renderer("katex", inline_renderers=(inline, None), block_renderers=(block, None))
