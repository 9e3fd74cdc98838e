"""Writes docs/scene-reference.md, every key of a scene file, from schema/scene.schema.json.

    python docs/site/scene_reference.py [--check]

`--check` fails where the page is not what the schema says. Needs Python 3.11 and nothing else.
"""

import argparse
import json
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]
SCHEMA = ROOT / "schema/scene.schema.json"
PAGE = ROOT / "docs/scene-reference.md"

HEAD = """\
# Scene reference

Every key of a scene file, written by `python3 docs/site/scene_reference.py` from [`schema/scene.schema.json`](../schema/scene.schema.json), which is made from the types of the library.
[Simulate](simulate.md) explains how a scene is built up; a key that is unknown, or has no effect, is an error.

In the column *if left out*, **required** marks a key that must be there, and – one whose absence the description explains.
"""
PLURAL = {"string": "strings", "a word": "words"}
#: Where each definition is told: objects in the order in which a scene is written.
ORDER = ("Material", "Section", "Rod", "Support", "Force", "Temperature", "Imperfection", "Motion", "Time", "Probe", "Output", "Shapes")


def code(value) -> str:
    return f"`{json.dumps(value, ensure_ascii=False)}`"


def cell(text: str) -> str:
    """Text inside a table; what Rust calls `None` is a key that is left out."""
    text = text.replace("`ThermalModel::None`", '`"none"`').replace("`None`", "left out")
    return text.replace("|", "\\|").replace("\n", " ")


class Reference:
    """The page."""

    def __init__(self, schema: dict) -> None:
        self.schema = schema
        self.definitions = schema["$defs"]

    def is_object(self, name: str) -> bool:
        return self.definitions[name].get("type") == "object"

    def kind(self, field: dict) -> str:
        """Type of a value, in words."""
        if "$ref" in field:
            name = field["$ref"].removeprefix("#/$defs/")
            return f"[{name}](#{name.lower()})" if self.is_object(name) else "a word"
        kind = field.get("type")
        if kind == "array":
            item = self.kind(field["items"])
            size = field.get("minItems")
            if size is not None and size == field.get("maxItems"):
                return f"[{', '.join([item] * size)}]"
            return f"list of {PLURAL.get(item, item)}"
        if kind == "object":
            return f"object of names, each with {self.kind(field['additionalProperties'])}"
        if kind not in ("number", "integer", "string", "boolean"):
            raise SystemExit(f"{SCHEMA.name}: {field} is of a kind that docs/site/scene_reference.py does not know; teach it")
        return kind

    def words(self, field: dict) -> list[dict]:
        """Words that a value may be."""
        inner = field.get("items", field)
        if "$ref" not in inner:
            return []
        # Of an object `oneOf` says which keys go together.
        return [word for word in self.definitions[inner["$ref"].removeprefix("#/$defs/")].get("oneOf", []) if "const" in word]

    def allowed(self, field: dict) -> str:
        limits = [f"≥ {field['minimum']}"] if "minimum" in field else []
        limits += [f"≤ {field['maximum']}"] if "maximum" in field else []
        return ", ".join(limits + [code(word["const"]) for word in self.words(field)]) or "–"

    def table(self, definition: dict) -> list[str]:
        """Keys of an object, then the words that need an explanation."""
        lines = ["| key | type | if left out | what | allowed |", "|---|---|---|---|---|"]
        explained = []
        required = definition.get("required", [])
        # Required keys first, as a reader needs them.
        for name, field in sorted(definition["properties"].items(), key=lambda item: (item[0] not in required, item[0])):
            absent = "**required**" if name in required else code(field["default"]) if "default" in field else "–"
            what = field.get("description", "")
            if not what:
                raise SystemExit(f"{SCHEMA.name}: {name} has no description; give its field a doc comment")
            lines.append(f"| `{name}` | {self.kind(field)} | {absent} | {cell(what)} | {self.allowed(field)} |")
            if words := self.words(field):
                explained += ["", f"`{name}` is one of:" if field.get("type") != "array" else f"`{name}` lists any of:", ""]
                explained += [f"* {code(word['const'])}: {word['description']}" for word in words]
        if together := [" and ".join(code(key) for key in choice["required"]) for choice in definition.get("oneOf", []) if "required" in choice]:
            explained += ["", f"Required: {', or '.join(together)}."]
        return lines + explained

    def page(self) -> str:
        objects = {name for name in self.definitions if self.is_object(name)}
        if objects != set(ORDER):
            raise SystemExit(f"{SCHEMA.name} has the objects {sorted(objects)}, docs/site/scene_reference.py tells {sorted(ORDER)}; add to ORDER")
        lines = [HEAD, "## Scene", "", "The whole file.", "", *self.table(self.schema)]
        for name in ORDER:
            definition = self.definitions[name]
            lines += ["", f"## {name}", "", definition["description"], "", *self.table(definition)]
        return "\n".join(lines) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    check = parser.parse_args().check
    page = Reference(json.loads(SCHEMA.read_text(encoding="utf-8"))).page()
    if not check:
        PAGE.write_text(page, encoding="utf-8")
    elif not PAGE.exists() or PAGE.read_text(encoding="utf-8") != page:
        sys.exit(f"{PAGE.relative_to(ROOT)} is not what schema/scene.schema.json says; run python3 docs/site/scene_reference.py")


if __name__ == "__main__":
    main()
