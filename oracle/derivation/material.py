"""(15)-(17): stress from strain."""

import sympy

from . import symbols as Y
from .algebra import Matrix
from .notation import Quotient, Symbol, Table, node
from .symbols import bar_1, bar_2, bar_3, eps, lam, mu, sigma, sigma_1, sigma_2, sigma_3

E, nu = Symbol("E", sympy.Symbol("E", positive=True)), Symbol(r"\nu", sympy.Symbol("nu", positive=True))


def from_density():
    """Derivative of C_ijkl E_ij E_kl / 2 by E_11, E_22 and E_12, with E_12 and E_21 independent; strains; Lame's constants."""
    names = sympy.symbols("E_11 E_12 E_21 E_22")
    tensor = sympy.Matrix(2, 2, names)
    first, second = sympy.symbols("lam mu")
    delta = sympy.eye(2)
    density = sum(
        (first * delta[i, j] * delta[k, m] + second * (delta[i, k] * delta[j, m] + delta[i, m] * delta[j, k]))
        * tensor[i, j] * tensor[k, m] / 2 for i in range(2) for j in range(2) for k in range(2) for m in range(2))
    E_11, E_12, E_21, E_22 = names
    shear = sympy.Symbol("E_s")
    return [[component.subs({E_12: shear, E_21: shear}) for component in
             (density.diff(E_11), density.diff(E_22), density.diff(E_12))], (E_11, E_22, shear), (first, second)]


def elasticity():
    """The matrix from strain to stress components 11, 22, 12, in the ring."""
    stress, strains, constants = from_density()
    return Matrix([[Y.lift(sympy.expand(component).coeff(strain), (*constants, sympy.Symbol("l"))) for strain in strains]
                   for component in stress])


def constants():
    """Lame's constants from a bar in three dimensions: the stress E stretches it by 1 and contracts it by nu."""
    first, second = sympy.symbols("first second")
    stretch, across = 1, -nu.meaning
    trace = stretch + 2 * across
    solution = sympy.solve([first * trace + 2 * second * stretch - E.meaning, first * trace + 2 * second * across],
                           [first, second], dict=True)[0]
    return solution[first], solution[second]


LAMBDA, MU = constants()
lambda_of, mu_of = Symbol(r"\lambda", LAMBDA), Symbol(r"\mu", MU)
D = Symbol(r"\mathbf D", elasticity())


def write(page):
    """The chapter."""
    page.heading("4 Stress: Hooke's law for large motions")
    page.words("""The law of St Venant and Kirchhoff is Hooke's, with the strain (14) in the place of the small one.
        Its stress is the second of Piola and Kirchhoff: it knows nothing of the rotation, as the strain does not.""")

    page.section("15", "Stress from strain", ["equations.material::sigma"])
    page.words("""Hooke's law of an isotropic body: a pressure from the change of volume, and twice {mu} times each
        component. {b_1}, {b_2} and {b_3} are the components of {eps}:""", mu=mu, b_1=bar_1, b_2=bar_2, b_3=bar_3, eps=eps)
    page.formulas_of([
        (sigma_1, lam * (bar_1 + bar_2) + 2 * mu * bar_1),
        (sigma_2, lam * (bar_1 + bar_2) + 2 * mu * bar_2),
        (sigma_3, 2 * mu * bar_3)],
        how="The left sides are the tensor's law, the first constant of Lamé times its trace and twice the second times itself.")
    page.words("As a matrix times a column this is")
    page.formula(sigma, D * eps, number="15",
                 how="The left side is the tensor's law.")

    page.section("16", "The elasticity matrix", ["equations.material::D"])
    page.formula(D, Table([lam + 2 * mu, lam, 0], [lam, lam + 2 * mu, 0], [0, 0, 2 * mu]), number="16",
                 how="""The left side is the derivative of the energy density by the tensor's four components, each
        taken for itself; then the two shear components are the same number.""")
    page.words("""As a law of stress this is right: the last line says {shear} for the tensor's components. As the
        matrix of an energy it is not, see (18). It is the matrix of plane strain: nothing moves across the plane
        ([M1](#m1-plane-strain-but-heat-in-the-plane-only)).""",
               shear=sigma_3)

    page.section("17", "Lamé's constants", ["equations.material::lambda", "equations.material::mu"])
    page.words("""Tables list Young's modulus {E} in Pa and Poisson's ratio {nu}: what a bar does that is pulled. It
        stretches by the stress over {E}, and shrinks across by {nu} times that, in both directions. Stretch it by one: the
        stress along is {E}, that across zero. Hooke's law in three dimensions says so in two lines, whose difference is
        the third:""", E=E, nu=nu)
    page.formulas_of([
        (E, lambda_of * (1 - 2 * nu) + 2 * mu_of),
        (node(0), lambda_of * (1 - 2 * nu) - 2 * mu_of * nu),
        (E, 2 * mu_of * (1 + nu))],
        how="With the constants that a computer algebra system finds from the law.")
    page.words("""The third gives {mu}, and with it the second {lam}:""", mu=mu, lam=lam)
    page.formulas_of([
        (lambda_of, Quotient(E * nu, (1 + nu) * (1 - 2 * nu))),
        (mu_of, Quotient(E, 2 * (1 + nu)))],
        number="17", how="The left sides solve the law of a bar in three dimensions under tension.")
