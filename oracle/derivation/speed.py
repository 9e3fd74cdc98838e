"""The element arranged for speed: integrals over the section by hand."""

from . import symbols as Y
from .algebra import GEN, column, replace
from .calculus import Integral
from .force import U
from .notation import PRODUCT, Quotient, Symbol, node
from .symbols import h, heat, lam, mu, w, y

half = node("1/2")


def at_axis(component):
    """A function restricted to the axis."""
    return replace(component, y=Y.ZERO)


def write(page):
    """The chapter."""
    page.heading("8 For speed: the section by hand")
    page.rust("elements.ancf::Ancf")
    page.words("""Fifteen Gauss points with matrices of 14 rows are the formulas as they read, not how a program
        should run. Four steps make the same numbers faster: the kernel that takes them
        is 350 times as fast in the force and 130 times in the tangent (`cargo bench --bench kernel`, measured in
        `docs/evidence.md`).""")
    page.words("""**First, split the position.** (A.1) is linear in {y}: an axis {c} and a director {d}, whose derivatives
        along the axis are marked by a prime.""", y=y, c=Symbol(r"\mathbf c", 0), d=Symbol(r"\mathbf d", 0))
    components = Y.r_components()
    axis = [at_axis(r) for r in components]
    director = [r.derivative("y") for r in components]
    axis_r, d = Symbol(r"\mathbf c", column(axis)), Symbol(r"\mathbf d", column(director))
    axis_x, d_x = (Symbol(rf"{symbol.text}'", symbol.meaning.each(lambda f: f.derivative("x"))) for symbol in (axis_r, d))
    page.formula(Y.r, axis_r + y * d, how="""The left side is (A.1); on the right are its value on the axis and its
        derivative across.""")
    page.words("""**Second, stay in the rod's own axes**, as the energy does not depend on the frame (that is what
        E3 was about). The strains are then polynomials in {y} whose coefficients live on the axis.""", y=y)
    own = Y.own_strain()
    # eps_11 = a_0 + a_1 y + a_2 y^2 and so on: the coefficients are derivatives of the strain at y = 0.
    kappa_0, kappa_1, kappa_2 = (Symbol(rf"\kappa_{k}", coefficient(own[0, 0], k)) for k in range(3))
    nn = Symbol(r"\bar\varepsilon_{nn}", own[1, 1])
    gamma_0, gamma_1 = (Symbol(rf"\gamma_{k}", coefficient(own[0, 1] * 2, k)) for k in range(2))
    e_11, e_12 = (Symbol(rf"\bar\varepsilon_{{{n}}}", own[place]) for n, place in (("tt", (0, 0)), ("tn", (0, 1))))
    page.words("""Along, across and sheared (a director has one length through the whole section, so {c} does not
        depend on {y}):""", c=nn, y=y)
    page.formulas_of([(e_11, kappa_0 + kappa_1 * y + kappa_2 * y**2), (2 * e_12, gamma_0 + gamma_1 * y)],
                     how="""The left sides are products of slopes; the coefficients on the right derivatives of them
        on the axis.""")
    page.formulas_of([
        (kappa_0, half * (axis_x.T * axis_x - 1) - heat), (kappa_1, axis_x.T * d_x), (kappa_2, half * d_x.T * d_x),
        (nn, half * (d.T * d - 1) - heat), (gamma_0, axis_x.T * d), (gamma_1, d.T * d_x)],
        how="The left sides are derivatives of the strains on the axis.")
    page.words("""**Third, integrate across by hand.** Only three numbers of the section are needed, its area, its
        second moment and its fourth:""")
    one = Symbol("1", Y.ONE)
    A, second, fourth = (Symbol(text, moment(k)) for text, k in (("A", 0), ("I_2", 2), ("I_4", 4)))
    page.formulas_of([(A, Integral("A", one), w * h), (second, Integral("A", y**2), Quotient(w * h**3, node(12))),
                      (fourth, Integral("A", y**4), Quotient(w * h**5, node(80)))],
                     how="The left sides are the antiderivatives' differences.")
    page.formula(
        U, half * Integral("l", (lam + 2 * mu) * (A * (kappa_0**2 + nn**2) + second * (kappa_1**2 + 2 * kappa_0 * kappa_2) + fourth * kappa_2**2)
                           + 2 * lam * nn * (A * kappa_0 + second * kappa_2) + mu * (A * gamma_0**2 + second * gamma_1**2)),
        how="The left side is the energy (18), integrated over the volume.")
    page.words("""So five points along the axis remain of the fifteen, and six numbers at each.""")
    page.words("""**Fourth, calculate with displacements.** A strain of a millionth, taken as a difference of
        squares near one, has lost six of sixteen digits. With the initial directions {t} along the rod and {n}
        across it, and what the slopes have beyond them, {p} and {delta}, no one is subtracted from a number near
        one:""", t=T, n=N, p=Symbol(r"\delta\mathbf t", 0), delta=Symbol(r"\delta\mathbf n", 0))
    p = Symbol(r"\delta\mathbf t", axis_x.meaning - T.meaning, PRODUCT)
    delta = Symbol(r"\delta\mathbf n", d.meaning - N.meaning, PRODUCT)
    page.formulas_of([
        (axis_x, T + p), (d, N + delta),
        (kappa_0, T.T * p + half * p.T * p - heat), (nn, N.T * delta + half * delta.T * delta - heat),
        (gamma_0, T.T * delta + N.T * p + p.T * delta)],
        how="The left sides are those above, the initial directions those of (9) at any inclination.")


T, N = (Symbol(text, column([Y.J_0.meaning[i, k] for i in Y.PLANE])) for text, k in ((r"\mathbf t", 0), (r"\mathbf n", 1)))


def coefficient(strain, k):
    """Coefficient of y^k in a polynomial."""
    factorial = (1, 1, 2)[k]
    for _ in range(k):
        strain = strain.derivative("y")
    return at_axis(strain) * Y.fmpq(1, factorial)


def moment(k):
    """w times the integral of y^k over the height, by its antiderivative at both faces."""
    primitive = GEN["y"] ** (k + 1) * Y.fmpq(1, k + 1)
    face = GEN["h"] * Y.HALF
    return (replace(primitive, y=face) - replace(primitive, y=-face)) * GEN["w"]
