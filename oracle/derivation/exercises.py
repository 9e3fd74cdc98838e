"""Exercises whose answers are commands."""

EXERCISES = (
    ("""Take the printed first coefficient (E1) and ask the nodal conditions (A.2) of it. Which of the seven
     fail, and by how
     much? Work it out, then look at what the test asserts.""",
     "cargo test --test errata e1 -- --nocapture && grep -n -A 20 'fn e1' tests/errata.rs",
     """Those at the middle, position and slope along, by the vector of the far end and twice that over the
     length; and that at the far end,
     by twice the vector."""),
    ("""Which fields does the element represent exactly? Show from (A.5) that all linear ones are among them.
     What would a program lose
     without that?""",
     "cargo test --test properties linear_fields_are_reproduced",
     """All linear ones: moved, turned, uniformly strained. Without them refining a mesh need not approach
         anything."""),
    ("""How many Gauss points along the axis and across it does (21) need, and what if one is left out, along or
        across? Count degrees first.""",
     """python -m oracle proofs | grep Gauss && cargo test --test properties the_rule_is_exact_to_its_degree
mkdir -p out
sed 's/leggauss(5)/leggauss(4)/' fixtures/adapters/ancf_numpy.py > out/four.py && ancf conform -- python3 out/four.py
sed 's/leggauss(3)/leggauss(2)/' fixtures/adapters/ancf_numpy.py > out/two.py && ancf conform -- python3 out/two.py""",
     """Five and three: degrees eight and four, M5. Measured from the middle, four along lose 5.2 % of the part of degree
     eight, two across 44 % of that of degree four. The mass needs fewer and does not change, nor does an element that is evenly
     strained; the forces of bent ones do: 19.Q_e is wrong in 13 of the 36 states with four along, in 11 with two across. It is
     still the derivative of the energy that is summed up, so tests of consistency see nothing."""),
    ("""A free rod of one metre in the direction (3, 4) is 200 K warmer than when it was made, at the
     pendulum's thermal expansion. Where is
     its end? (M2)""",
     "ancf scene free-rod-heated && ancf run free-rod-heated",
     """At its length times the root of one and twice the thermal strain, 1.00568, along its direction:
     0.603410 and 0.804547 m. With one and the
     thermal strain, 1.0057, it would be 0.603420 and 0.804560."""),
    ("""The same rod between two walls, at Poisson's ratio 0.3, heated by 5 K: what presses on the walls? (M8)
     Does heat across the rod
     change the answer?""",
     "cargo test --test statics a_heated_rod_between_walls_is_pressed && grep -n 'let force = 2e8' tests/statics.rs",
     """The section times the stress of M8, the same in both models. The reactions are found to nine digits of
     it, for rods in
     any direction."""),
    ("""Give the cantilever's material the Poisson's ratio 0.3. Which part of its curvature will the element
     allow? (M3) And with
     Poisson's terms on the axis alone?""",
     """mkdir -p out
ancf scene cantilever | sed 's/"nu": 0.0/"nu": 0.3/' > out/nu.json && ancf run out/nu.json
sed 's/"elements"/"poisson": "axis", "elements"/' out/nu.json > out/axis.json && ancf run out/axis.json""",
     """81.6 %, the formula of M3 at 0.3; the program warns of it. The tip goes down by 0.773 m; with Poisson's
     terms on the axis alone
     the warning is gone, and it is 0.797 m."""),
    ("""A rod at 45 degrees is pulled. How much of its stiffness does the printed energy (E3) leave? Use the
        last formula of (18), that of the compliance.""",
     "cargo test --test errata e3_printed_rod_at_45_degrees",
     """Two thirds: the compliance has the factor one and a half."""),
    ("""Someone says that the element of E2 is right, because the factor in front of the printed third matrix
     can be chosen so that nothing
     moves. Which state refutes that?""",
     "cargo test --test errata e2",
     """The undeformed one. Its force is a multiple of one vector that is not zero, whatever the inclination;
     no shear modulus but zero makes it
     vanish."""),
    ("""What need not be computed for the pendulum without heat, and what for the heated one? Say which terms
        of (21) are gone, then ask.""",
     "ancf plan pendulum-flexible && ancf plan pendulum-2d",
     """Without heat the thermal terms; without Poisson's ratio the second matrix in both."""),
    ("""A point is held twice on the same line (E4, (23)). The motion is determined; why are the multipliers
     not? Look at the matrix of the
     last formula's two lines.""",
     "cargo test --test errata e4 && grep -n -A 24 'fn e4' tests/errata.rs",
     """The two rows of the derivative matrix are equal, so the matrix for accelerations and multipliers
     together is singular: only the sum of the two
     forces is determined. That is why scenes with redundant supports are refused."""),
    ("""The tangent is symmetric, and the force and the tangent are derivatives of one energy. How would you
     test that of a program whose
     source you cannot read?""",
     "cargo test --test properties forces_and_tangent_are_derivatives",
     """By differences of its energy along random directions; as the energy is a polynomial of degree four, a
     five-point rule is exact but for
     rounding."""),
    ("""Change a sign in one of the formulas of this page, in oracle/derivation, and make it again. What
     happens? Then find a change
     that nobody would notice.""",
     "python -m oracle derivation --check",
     """The assertion that belongs to it ends the program and prints both sides. Every small change that is not
     noticed is declared in the
     source beside its formula: it scales what is
     zero, transposes what is symmetric, or moves where nothing varies."""),
)


def write(page):
    """The chapter."""
    page.heading("9 Exercises")
    page.words("""The answer to each is a command; under it, folded away, what to see. `ancf` is what `cargo
     install --path cli` installs,
        `python -m oracle` needs the packages of `oracle/requirements.txt`; all run in the repository's folder.""")
    for k, (question, command, answer) in enumerate(EXERCISES, 1):
        page.words(f"**{k}.** {question}")
        page.commands(command)
        page.details("Answer", answer)
