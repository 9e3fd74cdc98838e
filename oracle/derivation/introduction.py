"""The page's beginning: what it is, how to read it, its symbols."""

from .notation import Symbol


def name(text):
    """A symbol that is only named."""
    return Symbol(text, 0)


ROWS = (
    (r"x,\ y", "coordinates of a material point, along the element from its beginning and across from its axis", "m"),
    (r"l,\ h,\ w", "length; height of the section, in the plane; width, across the plane", "m"),
    (r"\mathbf r", "position of a material point now, in global axes, two components", "m"),
    (r"\mathbf r_x,\ \mathbf r_y", "its derivatives by the coordinates: slopes", "1"),
    (r"\mathbf r^i,\ \mathbf r^j,\ \mathbf r^k", "positions of the nodes at the beginning, the middle and the end", "m"),
    (r"\mathbf e,\ \mathbf e_0", "the 14 nodal coordinates, now and at the start", "m; slopes 1"),
    (r"\mathbf S,\ S_1 \dots S_7", "shape matrix, two rows and 14 columns; shape functions", "1; of slopes m"),
    (r"\rho,\ \mathbf g", "density; acceleration of gravity", "kg/m³; m/s²"),
    (r"T,\ U,\ W", "kinetic energy; strain energy; work of the loads", "J"),
    (r"\mathbf M,\ \mathbf K", "mass matrix and stiffness matrix, 14 rows and columns", "kg; N/m (slopes: times m, m²)"),
    (r"\mathbf Q_e,\ \mathbf Q_w", "elastic forces; forces of the loads", "N; on slopes N m"),
    (r"\theta", "inclination of the straight element at the start", "rad"),
    (r"\mathbf J,\ \mathbf J_0", "deformation gradient; gradient of the initial position", "1"),
    (r"\boldsymbol\varepsilon_f,\ \boldsymbol\varepsilon_T,\ \boldsymbol\varepsilon",
     "strain as a column (11, 22, 12); thermal strain; strain that makes stress", "1"),
    (r"\mathbf S_a,\ \mathbf S_b,\ \mathbf S_c", "matrices of the metric: its components 11, 22, 12 as quadratic forms", "1/m²; slopes 1/m, 1"),
    (r"\boldsymbol\sigma,\ \mathbf D", "stress as a column (11, 22, 12), the second of Piola and Kirchhoff; elasticity matrix", "Pa"),
    (r"E,\ \nu", "Young's modulus; Poisson's ratio", "Pa; 1"),
    (r"\lambda,\ \mu", "Lamé's constants; the second is the shear modulus", "Pa"),
    (r"\alpha_T,\ \Delta T", "coefficient of thermal expansion; change of temperature", "1/K; K"),
    (r"\mathbf q,\ \boldsymbol\Phi,\ \boldsymbol\lambda", "coordinates of a structure; conditions on them; their multipliers", "as nodal coordinates; m; N"),
)


def write(page, formulas, changes, none):
    """The front matter, with the numbers of what was checked."""
    page.heading("The derivation that runs", 1)
    page.words("""From the polynomial (A.1) to the motion of pinned rods (23): the planar thermo-elastic beam of
        Peng, Wang, Li, Zhi and Li ([doi 10.1155/2018/1752815](https://doi.org/10.1155/2018/1752815)), equation by
        equation in the paper's numbers, with what the paper leaves out and what it prints wrong. It asks for linear
        algebra and calculus of several variables, and no figures of the paper.""")
    page.words("""**Made by a program, not typed.** `python -m oracle derivation` ([source](derivation)) builds
        every displayed formula as a tree, writes it from the tree, computes it from the same tree, and asserts that
        it is equal to its left side, which is found another way: by solving, differentiating or integrating what
        comes before. The line under each formula says how. An assertion that fails ends the program, and no page is
        made; `python -m oracle derivation --check` fails when this page is not what the program makes.""")
    page.words(f"""**And can it fail?** The program then makes small mistakes in every formula, one at a time: a
        sign turned, a symbol doubled, a number raised by one, a transpose or an inverse dropped, a sine in the
        place of a cosine. Of {changes} mistakes in {formulas} formulas all were noticed but {none}, which are none:
        they scale what is zero, transpose what is symmetric, or move where nothing varies, and are declared as such in the source.""")
    page.words("""In the text formulas are names only. Chapters:
        [position](#1-position-from-a-polynomial-to-shape-functions),
        [inertia](#2-inertia-a-mass-matrix-that-never-changes), [strain](#3-strain-what-deformation-is),
        [stress](#4-stress-hookes-law-for-large-motions), [energy and forces](#5-energy-and-forces),
        [motion](#6-motion), [choices](#7-choices-to-know), [speed](#8-for-speed-the-section-by-hand),
        [exercises](#9-exercises). Errors in the paper: [E1](#a3-the-coefficients), [E2](#21-its-parts),
        [E3](#18-strain-energy), [E4](#23-elements-held-together).""")
    page.heading("Symbols and units")
    page.words("""Bold small letters are columns, bold capitals matrices; a raised T is a transpose, a dot a
        derivative by time. SI units; where nodal coordinates mix positions and slopes, the unit for positions, then
        for slopes.""")
    page.table(("symbol", "what it is", "unit"), [(f"{name(text)}", what, unit) for text, what, unit in ROWS])
