"""The JSON Schemas of `fixtures/schema/`: whether the files are what they say, and whether they say what each entry is.

Checked here and not by a Rust test: the oracle's environment exists for the fixtures, and a validator of schemas is nothing that
the program needs.
"""

import json

import jsonschema

from . import fixture

# Which files a schema is for.
FILES = {
    "equations.json": "equations",
    "cable.json": "cable",
    "structure.json": "structure",
    "pendulum.json": "pendulum",
    "references.json": "references",
    "continuum.json": "continuum",
    "calculix.json": "calculix",
    "invalid.json": "invalid",
    **{f"converged/{path.name}": "converged" for path in sorted((fixture.FOLDER / "converged").glob("*.json"))},
}


def schema(name):
    """A schema, which has to be one itself."""
    found = json.loads((fixture.FOLDER / "schema" / f"{name}.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(found)
    return found


def faults():
    """Where a file is not what its schema says, and fixtures without a schema."""
    there = {str(path.relative_to(fixture.FOLDER)) for path in fixture.FOLDER.glob("**/*.json")
             if path.parent.name != "schema"}
    found = [f"fixtures/{name}: no schema is named for it in oracle/schemas.py" for name in sorted(there - set(FILES))]
    for name in FILES:
        validator = jsonschema.Draft202012Validator(schema(FILES[name]))
        for error in validator.iter_errors(json.loads((fixture.FOLDER / name).read_text(encoding="utf-8"))):
            found.append(f"fixtures/{name}: {error.json_path}: {error.message:.120}")
    for path in sorted((fixture.FOLDER / "schema").glob("*.json")):
        unexplained = without_description(json.loads(path.read_text(encoding="utf-8")))
        found += [f"fixtures/schema/{path.name}: {place}: no description" for place in unexplained]
    return found


def without_description(node, place="$"):
    """Where a property of a schema says nothing of what it holds."""
    if isinstance(node, list):
        return [fault for n, entry in enumerate(node) for fault in without_description(entry, f"{place}[{n}]")]
    if not isinstance(node, dict):
        return []
    properties = node.get("properties")
    named = properties if isinstance(properties, dict) else {}
    found = [f"{place}.properties.{key}" for key, entry in named.items()
             if not (isinstance(entry, dict) and str(entry.get("description", "")).strip())]
    for key, entry in named.items():
        found += without_description(entry, f"{place}.properties.{key}")
    return found + [fault for key, entry in node.items() if key != "properties"
                    for fault in without_description(entry, f"{place}.{key}")]
