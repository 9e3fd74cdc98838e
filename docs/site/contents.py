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
    ("Teaching", [
        ("teaching", "teaching/README.md"),
        ("teaching/1-shape", "teaching/1-shape.md"),
        ("teaching/2-mass", "teaching/2-mass.md"),
        ("teaching/3-rest", "teaching/3-rest.md"),
        ("teaching/4-first-step", "teaching/4-first-step.md"),
        ("teaching/5-heat", "teaching/5-heat.md"),
        ("teaching/6-locking", "teaching/6-locking.md"),
        ("teaching/7-errata", "teaching/7-errata.md"),
        ("teaching/8-another-program", "teaching/8-another-program.md"),
        ("teaching/9-lecture", "teaching/9-lecture.md"),
        ("teaching/solutions/1-shape", "teaching/solutions/1-shape.md"),
        ("teaching/solutions/2-mass", "teaching/solutions/2-mass.md"),
        ("teaching/solutions/3-rest", "teaching/solutions/3-rest.md"),
        ("teaching/solutions/4-first-step", "teaching/solutions/4-first-step.md"),
        ("teaching/solutions/5-heat", "teaching/solutions/5-heat.md"),
        ("teaching/solutions/6-locking", "teaching/solutions/6-locking.md"),
        ("teaching/solutions/7-errata", "teaching/solutions/7-errata.md"),
        ("teaching/solutions/8-another-program", "teaching/solutions/8-another-program.md"),
        ("teaching/solutions/9-lecture", "teaching/solutions/9-lecture.md"),
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
        ("release", "docs/release.md"),
    ]),
]

#: Pages of the repository whose place in the book is the first page.
FRONT = ("README.md", "docs/README.md", "docs/site/front.md")

#: What the contents call a page, where its own title says too little there.
TITLES = {
    "derivation": "The derivation, (A.1) to (23)",
    "equations": "Equations, errors E1–E5, choices M1–M8",
    "fixtures": "Fixtures: numbers to check against",
    "pytest": "Fixtures in Python, with pytest",
    "wheel": "The program as a wheel",
    "paper": "Sections 3 and 4, measured",
    "evidence": "Evidence",
    "fixtures-changelog": "Changelog of the fixtures",
}
