"""Fenced blocks of Markdown."""

import re

#: Ticks, what stands behind them, and the content.
FENCE = re.compile(r"^(`{3,})([^\n`]*)\n(.*?)^\1$\n?", re.M | re.S)
