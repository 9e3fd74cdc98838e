"""Fixture files: exact numbers as text, their nearest f64, and a JSON layout a person can read."""

import hashlib
import json
from pathlib import Path

import sympy
from flint import fmpq

from . import versions

FOLDER = Path(__file__).resolve().parent.parent / "fixtures"


def rational(value):
    """A rational number as text: "-3/8", or "2" when it is whole."""
    return str(value)


def nearest(value):
    """The f64 nearest to a rational number (true division of integers rounds correctly)."""
    return int(value.p) / int(value.q)


def to_sympy(value):
    """The same rational number in sympy."""
    return sympy.Rational(int(value.p), int(value.q))


def from_sympy(value):
    """The same rational number in python-flint."""
    return fmpq(int(value.p), int(value.q))


def each(convert, values):
    """The same nesting of lists with `convert` applied to every number in it."""
    if isinstance(values, (list, tuple)):
        return [each(convert, value) for value in values]
    return convert(values)


def render(document):
    """JSON text with one line for each quantity, state or point rather than for each number."""
    return _indented(document, 0) + "\n"


def _indented(node, depth):
    """A table, or a list of tables, gets a line an entry as long as its entries hold tables."""
    pad, end = "\n" + " " * (depth + 1), "\n" + " " * depth
    if isinstance(node, dict) and (depth < 2 or any(isinstance(v, dict) for v in node.values())):
        entries = (f"{json.dumps(k)}: {_indented(v, depth + 1)}" for k, v in node.items())
        return "{" + pad + ("," + pad).join(entries) + end + "}"
    if isinstance(node, list) and any(isinstance(v, dict) for v in node):
        entries = (_indented(v, depth + 1) for v in node)
        return "[" + pad + ("," + pad).join(entries) + end + "]"
    return json.dumps(node, ensure_ascii=False, allow_nan=False, separators=(",", ":"))


def digest(document):
    """What "sha256" holds in a stored fixture: it shows an edit that is smaller than a comparison's tolerance."""
    return hashlib.sha256(render(document).encode()).hexdigest()


def write(name, document):
    """Writes a fixture with its version and its digest, whole or not at all; returns its size in bytes."""
    document = versions.stamped(name, document)
    text = render({**document, "sha256": digest(document)}).encode()
    FOLDER.mkdir(exist_ok=True)
    unfinished = FOLDER / (name + ".unfinished")
    unfinished.write_bytes(text)
    unfinished.replace(FOLDER / name)
    return len(text)


def read(name):
    """The stored fixture; a key written twice is refused, as one of the two would go unchecked."""

    def table(pairs):
        keys = [key for key, _ in pairs]
        repeated = {key for key in keys if keys.count(key) > 1}
        if repeated:
            raise ValueError(f"{name}: repeated keys {sorted(repeated)}")
        return dict(pairs)

    return json.loads((FOLDER / name).read_text(encoding="utf-8"), object_pairs_hook=table)


def differences(stored, fresh, path=""):
    """Where two documents differ in a key, a length, a type or a value, as lines to print.

    Types count, so that 1, 1.0 and true are three different things, and the order of keys does not.
    """
    if type(stored) is not type(fresh):
        return [f"{path}: stored {stored!r:.80}, derived {fresh!r:.80}"]
    if isinstance(fresh, dict):
        lines = [f"{path}.{key}: not derived" for key in stored if key not in fresh]
        lines += [f"{path}.{key}: missing" for key in fresh if key not in stored]
        shared = [key for key in fresh if key in stored]
        return lines + [d for k in shared for d in differences(stored[k], fresh[k], f"{path}.{k}")]
    if isinstance(fresh, list):
        if len(stored) != len(fresh):
            return [f"{path}: {len(stored)} entries stored, {len(fresh)} derived"]
        lines = []
        for i, (a, b) in enumerate(zip(stored, fresh)):
            label = b.get("id", i) if isinstance(b, dict) else i
            lines += differences(a, b, f"{path}[{label}]")
        return lines
    return [] if stored == fresh else [f"{path}: stored {stored!r:.80}, derived {fresh!r:.80}"]


def settled(stored, fresh, tolerance):
    """The stored value, with numbers within the tolerance replaced; a table of tolerances goes by key."""
    if type(stored) is dict and type(fresh) is dict:
        by_key = tolerance if type(tolerance) is dict else dict.fromkeys(fresh, tolerance)
        shared = by_key.keys() & stored.keys() & fresh.keys()
        return stored | {key: settled(stored[key], fresh[key], by_key[key]) for key in shared}
    if type(stored) is list and type(fresh) is list and len(stored) == len(fresh):
        return [settled(*pair, tolerance) for pair in zip(stored, fresh)]
    close = type(stored) is float and type(fresh) is float and abs(stored - fresh) <= tolerance
    return fresh if close else stored
