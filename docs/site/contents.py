"""Contents of the book: parts, and the pages of each by their place in the book and their source in the repository."""

PARTS = [
    ("Start", [
        ("first-picture", "docs/first-picture.md"),
        ("scenes", "scenes/README.md"),
    ]),
    ("Tutorials", [
        ("tutorials/two-rods", "docs/tutorials/two-rods.md"),
        ("tutorials/check-python", "docs/tutorials/check-python.md"),
        ("tutorials/check-octave", "docs/tutorials/check-octave.md"),
        ("tutorials/check-rust", "docs/tutorials/check-rust.md"),
        ("tutorials/review-a-change", "docs/tutorials/review-a-change.md"),
    ]),
    ("The element", [
        ("derivation", "oracle/DERIVATION.md"),
        ("equations", "docs/equations.md"),
    ]),
    ("Simulate", [
        ("simulate", "docs/simulate.md"),
        ("scene-reference", "docs/scene-reference.md"),
        ("methods", "docs/methods.md"),
        ("accuracy", "docs/accuracy.md"),
        ("many-runs", "docs/many-runs.md"),
    ]),
    ("Check your program", [
        ("check", "docs/check.md"),
        ("write-yours", "docs/write-yours.md"),
        ("fixtures", "fixtures/README.md"),
        ("protocol", "fixtures/PROTOCOL.md"),
        ("pytest", "python/fixtures/README.md"),
        ("wheel", "python/program/README.md"),
    ]),
    ("Measured", [
        ("paper", "docs/paper.md"),
        ("error-time", "docs/error-time.md"),
        ("stability", "docs/stability.md"),
    ]),
    ("Evidence", [
        ("evidence", "docs/evidence.md"),
        ("limits", "docs/limits.md"),
        ("oracle", "oracle/README.md"),
        ("snapshots", "docs/snapshots.md"),
        ("fixtures-changelog", "fixtures/CHANGELOG.md"),
        ("changelog", "CHANGELOG.md"),
        ("contributing", "CONTRIBUTING.md"),
    ]),
]

#: Pages of the repository whose place in the book is the first page.
FRONT = ("README.md", "docs/README.md", "docs/site/front.md")
