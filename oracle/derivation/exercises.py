"""Exercises whose answers are commands."""

EXERCISES = (
    ("""Take the printed first coefficient (E1) and ask the nodal conditions (A.2) of it. Which of the seven fail, and by how
     much? Work it out, then look at what the test asserts.""",
     "cargo test --test errata e1 -- --nocapture && grep -n -A 20 'fn e1' tests/errata.rs",
     """Those at the middle, position and slope along, by the vector of the far end and twice that over the length; and that at the far end,
     by twice the vector."""),
    ("""Which fields does the element represent exactly? Show from (A.5) that all linear ones are among them. What would a program lose
     without that?""",
     "cargo test --test properties linear_fields_are_reproduced",
     """All linear ones: moved, turned, uniformly strained. Without them refining a mesh need not approach anything."""),
    ("""How many Gauss points along the axis and across it does (21) need, and what if one is left out? Count degrees first.""",
     "python -m oracle proofs | grep Gauss && cargo test --test properties the_rule_is_exact_to_its_degree",
     """Five and three: degrees eight and four, M5."""),
    ("""A rod that may expand freely is heated in statics. Where does its free end come to rest? (M2; the scene says how long and how hot.)""",
     "ancf scene free-rod-heated && ancf run free-rod-heated && tail -n 1 out/trajectory.csv",
     """At its length times the root of one and twice the thermal strain, and not times one and the thermal strain: compare the last
     digits."""),
    ("""The same rod between two walls, at Poisson's ratio 0.3, heated by 5 K: what presses on the walls? (M8) Does heat across the rod
     change the answer?""",
     "cargo test --test statics a_heated_rod_between_walls_is_pressed && grep -n 'let force = 2e8' tests/statics.rs",
     """The section times the stress of M8, the same in both models. The reactions are found to nine digits of it, for rods in
     any direction."""),
    ("""Give the cantilever's material the Poisson's ratio 0.3. By which factor does its tip go down less? (M3) And with
     Poisson's terms on the axis alone?""",
     """ancf run cantilever && tail -n 1 out/trajectory.csv
ancf scene cantilever | sed 's/"nu": 0.0/"nu": 0.3/' > out/nu.json && ancf run out/nu.json && tail -n 1 out/trajectory.csv
cargo test --test references -- --nocapture | grep -i poisson""",
     """By the formula of M3 times the plane-strain modulus's own share, one over one less the square of the ratio. The program warns of it.
     With Poisson's terms on the axis only that share remains."""),
    ("""A rod at 45 degrees is pulled. How much of its stiffness does the printed energy (E3) leave? Use the second formula under (18).""",
     "cargo test --test errata e3_printed_rod_at_45_degrees",
     """Two thirds: the compliance has the factor one and a half."""),
    ("""Someone says that the element of E2 is right, because the factor in front of the printed third matrix can be chosen so that nothing
     moves. Which state refutes that?""",
     "cargo test --test errata e2",
     """The undeformed one. Its force is a multiple of one vector that is not zero, whatever the inclination; no shear modulus but zero makes it
     vanish."""),
    ("""What need not be computed for the pendulum without heat, and what for the heated one? Say which terms of (21) are gone, then ask.""",
     "ancf plan pendulum-flexible && ancf plan pendulum-2d",
     """Without heat the thermal terms; without Poisson's ratio the second matrix in both."""),
    ("""How many multipliers have the three scissors as (23), and what do they cost beside pins as shared coordinates? Count the
     conditions first: pins and supports, two components each.""",
     """ancf plan scissors-3
ancf scene scissors-3 | sed 's/"time"/"constraints": "multipliers", "time"/' > out/multipliers.json && ancf plan out/multipliers.json""",
     """The plan counts unknowns in both forms; their difference is twice the number of conditions: once for the shared coordinate, once for
     its multiplier."""),
    ("""The tangent is symmetric, and the force and the tangent are derivatives of one energy. How would you test that of a program whose
     source you cannot read?""",
     "cargo test --test properties forces_and_tangent_are_derivatives",
     """By differences of its energy along random directions; as the energy is a polynomial of degree four, a five-point rule is exact but for
     rounding."""),
    ("""Change a sign in one of the formulas of this page, in oracle/derivation, and make it again. What happens? Then find a change
     that nobody would notice.""",
     "python -m oracle derivation --check",
     """The assertion that belongs to it ends the program and prints both sides. Every small change that is not noticed is declared in the
     source beside its formula: it doubles a zero, or transposes what is symmetric."""),
)


def write(page):
    """The chapter."""
    page.heading("9 Exercises")
    page.words("""The answer to each is a command; under it, folded away, what to see. `ancf` is what `cargo install --path .` installs,
        `python -m oracle` needs the packages of `oracle/requirements.txt`; all run in the repository's folder.""")
    for k, (question, command, answer) in enumerate(EXERCISES, 1):
        page.words(f"**{k}.** {question}")
        page.commands(command)
        page.details("Answer", answer)
