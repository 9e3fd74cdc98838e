"""The version of each fixture's content, and what tells that it has changed.

Content is everything but what describes the file: cases, values, tolerances, tags. `fixtures/CHANGELOG.md` says what each version
changed; a changed value gets a new first number, something new a new second one.
"""

import hashlib

LICENSE = "CC0-1.0"

# Version and digest of the content. After a change on purpose: raise the version, say in the changelog what changed, and
# put in the digest that `python -m oracle --check` names.
VERSIONS = {
    "equations.json": ("1.2", "27b76a496f141b44"),
    "cable.json": ("1.2", "fb296de80f8da682"),
    "structure.json": ("1.1", "fa38313c2b4cc44f"),
    "pendulum.json": ("1.0", "6ddfa629ac78db76"),
    "references.json": ("1.0", "6474f7ff25b8989f"),
    "continuum.json": ("1.0", "95c7ef0fce2e7cb6"),
    "calculix.json": ("1.0", "63645c5583b0f499"),
    "invalid.json": ("1.1", "8f28dc9182c23673"),
}

DESCRIBES = ("schema", "version", "license", "title", "source", "generator", "conventions", "settings", "sha256")


def stamped(name, document):
    """The document with version and license behind its schema."""
    version, _ = VERSIONS[name]
    stamps = {"version": version, "license": LICENSE}
    return {"schema": document["schema"], **stamps, **{key: document[key] for key in document if key != "schema"}}


def content(document, render):
    """Digest of what the file is there for."""
    kept = {key: value for key, value in document.items() if key not in DESCRIBES}
    return hashlib.sha256(render(kept).encode()).hexdigest()[:16]


def faults(name, stored, render, folder):
    """What is wrong with the version of a stored fixture; takes its stamps away."""
    version, digest = VERSIONS[name]
    found = []
    if (stored.pop("version", None), stored.pop("license", None)) != (version, LICENSE):
        found.append(f"version, license: not {version}, {LICENSE}")
    actual = content(stored, render)
    if actual != digest:
        found.append(f"its content ({actual}) is not that of version {version} ({digest}): see oracle/versions.py")
    if f"## {name} {version}" not in (folder / "CHANGELOG.md").read_text(encoding="utf-8"):
        found.append(f"fixtures/CHANGELOG.md does not say what is new in {version}")
    return found
