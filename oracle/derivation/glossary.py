"""The list of symbols, and the check that each symbol of the page stands in one line of it and means one thing."""

import re

from .notation import Symbol

# Symbols as they are shown; what they are; unit; all their forms on the page as patterns, without dots, primes and exponents.
NODE = r"(\^[ijk])?"
ROWS = (
    (r"x,\ y", "coordinates of a material point, along the element and across", "m", (r"[xy]",)),
    (r"\xi,\ \eta", "the same over the length (in the code `a`, `b`)", "1", (r"\\xi", r"\\eta")),
    (r"\hat x", "distance from the element's middle", "m", (r"\\hat x",)),
    (r"l,\ h,\ w", "length; height in the plane; width across it", "m", (r"[lhw]",)),
    (r"V,\ A", "volume; section and its area", "m³; m²", (r"[VA]",)),
    (r"i,\ j,\ k", "first, middle, last node", "", (r"[ijk]",)),
    (r"m,\ n,\ p", "indices of coordinates; of rows", "", (r"[mnp]",)),
    (r"t,\ \Delta t", "time; step", "s", (r"t", r"\\Delta t")),
    (r"\mathbf r,\ \mathbf r_0", "position now; at the start", "m", (r"\\mathbf r" + NODE, r"\\mathbf r_0", r"\\mathbf r_\\text\{(printed|ground|first|second)\}" + NODE)),
    (r"\mathbf r_x,\ \mathbf r_y", "slopes: its derivatives", "1", (r"\\mathbf r_[xy]" + NODE,)),
    (r"a_n,\ b_n,\ \mathbf a_n", "coefficients; their columns", "m, 1, …", (r"[ab]_[0-9n]", r"\\mathbf a_[0-9n]")),
    (r"S_1 \dots S_7", "shape functions", "1; slopes m", (r"S_[1-7]",)),
    (r"\mathbf S,\ \mathbf S_{1x}", "shape matrix; its first row by the first coordinate", "as above; 1/m", (r"\\mathbf S", r"\\mathbf S_[xy]", r"\\mathbf S_\{[12p][xy]\}")),
    (r"\mathbf e,\ e_n,\ \mathbf e_0", "nodal coordinates; one; at the start", "m; slopes 1", (r"\\mathbf e", r"e_[mn]", r"\\mathbf e_0")),
    (r"\mathbf I,\ \mathbf 0", "unit matrix; column of zeros", "1", (r"\\mathbf I", r"\\mathbf 0")),
    (r"\mathbf u", "some displacements in nodal coordinates", "m; slopes 1", (r"\\mathbf u_\\text\{\w+\}",)),
    (r"\rho,\ \mathbf g", "density; gravity", "kg/m³; m/s²", (r"\\rho", r"\\mathbf g")),
    (r"T,\ U,\ W", "kinetic and strain energy; work of the loads", "J", (r"[TUW]", r"U_\\text\{\w+\}")),
    (r"\mathbf M,\ \mathbf Q_w", "mass matrix; forces of the loads", "kg; N", (r"\\mathbf M", r"\\mathbf Q_w")),
    (r"\mathbf Q_e,\ \mathbf K", "elastic forces; stiffness matrix, and its parts", "N; N/m",
     (r"\\mathbf Q_e", r"\\mathbf K", r"\\mathbf K_[123]", r"\\mathbf K_\{3,\\text\{printed\}\}")),
    (r"\mathbf K_0", "tangent at rest, level; its halves", "N/m", (r"\\mathbf K_0", r"K_\{0,11\}", r"\\mathbf K_\\text\{(stretch|bend)\}")),
    (r"\mathbf P,\ \mathbf G,\ \mathbf N,\ \mathbf H", "integrals in it", "1; m", (r"\\mathbf [PGNH]",)),
    (r"\theta,\ \varphi", "inclination at the start; turn of a frame", "rad", (r"\\theta", r"\\varphi")),
    (r"\mathbf J,\ \mathbf J_0", "deformation gradient; at the start", "1", (r"\\mathbf J", r"\\mathbf J_0")),
    (r"\mathbf S_a,\ \mathbf S_b,\ \mathbf S_c", "metric's components 11, 22, 12 as forms; with 1 plus transpose", "1/m²",
     (r"\\mathbf S_[abc]", r"\\mathbf S_\{[abc]1\}", r"S_\{a,(nm|mn)\}")),
    (r"\mathbf z_a,\ \mathbf z_b,\ \mathbf z_c", "derivatives of these forms", "1/m", (r"\\mathbf z_[abc]",)),
    (r"\boldsymbol\varepsilon_m,\ \boldsymbol\varepsilon_f", "strain tensor; as a column 11, 22, 12", "1",
     (r"\\boldsymbol\\varepsilon_[mf]", r"\\varepsilon_[123]", r"\\varepsilon_\\text\{(paper|plane strain)\}")),
    (r"\boldsymbol\varepsilon_T", "thermal strain", "1", (r"\\boldsymbol\\varepsilon_T(\^\\text\{1D\})?",)),
    (r"\boldsymbol\varepsilon,\ \bar\varepsilon_1", "strain less heat; its components", "1", (r"\\boldsymbol\\varepsilon", r"\\bar\\varepsilon_[123]")),
    (r"\varepsilon_{tt},\ \bar\varepsilon_{tt}", "in the rod's own axes; less heat", "1", (r"(\\bar)?\\varepsilon_\{(tt|nn|tn)\}",)),
    (r"\boldsymbol\sigma,\ \mathbf D", "stress as a column; elasticity matrix", "Pa", (r"\\boldsymbol\\sigma", r"\\sigma_[123]", r"\\sigma_\{11\}", r"\\mathbf D")),
    (r"E,\ \nu,\ \lambda,\ \mu", "Young's modulus, Poisson's ratio; Lamé's constants", "Pa; 1; Pa", (r"E", r"\\nu", r"\\lambda", r"\\mu")),
    (r"\alpha_T,\ \Delta T", "thermal expansion; change of temperature", "1/K; K", (r"\\alpha_T", r"\\Delta T")),
    (r"\psi", "energy density", "J/m³", (r"\\psi", r"\\psi_\\text\{printed\}")),
    (r"B,\ C", "bending stiffness; compliance", "N m²; 1/N", (r"[BC]", r"[BC]_\\text\{printed\}")),
    (r"\mathbf q,\ \boldsymbol\Phi,\ \boldsymbol\Phi_q", "coordinates of a structure; conditions; derivative", "m; m; 1",
     (r"\\mathbf q", r"\\boldsymbol\\Phi", r"\\boldsymbol\\Phi_q", r"\\boldsymbol\\Phi_\\text\{twice\}")),
    (r"\boldsymbol\lambda", "multipliers", "N", (r"\\boldsymbol\\lambda",)),
    (r"\mathbf m,\ \mathbf k,\ \mathbf f", "mass, stiffness, loads of a structure", "as above", (r"\\mathbf [mkf]",)),
    (r"\Lambda", "stretch", "1", (r"\\Lambda",)),
    (r"u,\ v,\ \beta", "displacement along, across; rate of curvature", "m; 1/m²", (r"[uv]", r"\\beta")),
    (r"\mathbf c,\ \mathbf d", "axis; director", "m; 1", (r"\\mathbf [cd]",)),
    (r"\mathbf t,\ \mathbf n", "initial directions along, across", "1", (r"\\mathbf [tn]",)),
    (r"\kappa_0,\ \gamma_0", "coefficients of strains over the section", "1, 1/m, …", (r"\\kappa_[012]", r"\\gamma_[01]")),
    (r"I_2,\ I_4", "second and fourth moment of the section", "m⁴; m⁶", (r"I_[24]",)),
    (r"\mathbf a_\text{step}", "unit of acceleration of one step", "m/s²", (r"\\mathbf a_\\text\{step\}",)),
)
# Signs of calculation, and names under braces; a dot is a derivative by time, a prime one along the axis, a delta a small change.
SIGNS = re.compile(r"\\(begin|end)\{\w+\}|_\{\\text\{\w+\}\}|\^\{(\\mathsf T|-?\d+)\}|\^2|\\(ddot|dot|left|right|tfrac|frac|int|sum|partial|det|deg|cos|sin|sqrt"
                   r"|underbrace|otimes|cdot|dots|delta|mathrm d|tag\{[\w.]+\}|[\\, ])(?![a-zA-Z])")
SIGNS_AT_LETTERS = re.compile(r"\\(mathrm d|delta)(?=[a-zA-Z\\])")
SYMBOL = re.compile(r"\\Delta [Tt]|(?:\\(?:bar|hat) ?)?(?:\\(?:mathbf|boldsymbol) ?)?(?:\\[a-zA-Z]+|[a-zA-Z]|(?<=mathbf )0)"
                    r"(?:'*[_^](?:\\text\{[^}]*\}|\{[^{}]*(?:\{[^{}]*\})?\}|[a-zA-Z0-9]))*")


def symbols(tex):
    """Symbols of a printed formula with their indices, without signs of calculation."""
    plain = re.sub(r"\\deg_[xy]|\)_(?:\\text\{\w+\}|q)|\\mathrm d(?=V|A|x|t|\\)", "", tex)
    plain = re.sub(r"\\(ddot|dot)(?=[ {])", "", plain)
    # An accent's braces are no group of an index.
    plain = re.sub(r"\{(\\mathbf [a-z])\}", r"\1", plain)
    return SYMBOL.findall(SIGNS.sub(" ", SIGNS_AT_LETTERS.sub("", plain)))


def rows_of(symbol):
    """Lines of the list that a symbol stands in."""
    return [row for row in ROWS if any(re.fullmatch(pattern, symbol) for pattern in row[3])]


def assert_single(printed):
    """Asserts that every printed symbol stands in one line, and every line has a symbol on the page."""
    found = {symbol for tex in printed for symbol in symbols(tex)}
    lines = {symbol: rows_of(symbol) for symbol in found}
    missing = sorted(symbol for symbol, rows in lines.items() if not rows)
    assert not missing, f"symbols that the list has not: {missing}"
    double = sorted(symbol for symbol, rows in lines.items() if len(rows) > 1)
    assert not double, f"symbols with two lines: {double}"
    used = [row for rows in lines.values() for row in rows]
    assert all(row in used for row in ROWS), f"lines without a symbol: {[row[0] for row in ROWS if row not in used]}"
    return len(found)


def write(page):
    """The list."""
    page.table(("symbol", "what", "unit"), [(f"{Symbol(shown, 0)}", what, unit) for shown, what, unit, _ in ROWS])
