"""The mistakes that `element.cpp` can make, with what a report on each should say; decided before the kit was asked.

`equation` is the root's number in the paper. `quantities` are those that are truly wrong by this line of code and have
right inputs. `kinds` are names of the report's schema that describe it; `words` describe it where a kind is new there.
"""

from typing import NamedTuple


class Mistake(NamedTuple):
    """A mistake of the program."""

    name: str
    equation: str
    quantities: tuple
    kinds: tuple
    what: str
    route: str = "stress"
    words: tuple = ()

    # Later quantities that the same line makes wrong although their inputs are right: integrals over the same points.
    also: tuple = ()


def _of(equation, quantities, rows, route="stress", also=""):
    """Mistakes of one equation; a row may bring its own quantities."""
    out = []
    for name, kinds, what, *own in rows:
        names = own[0] if own else quantities
        out.append(Mistake(name, equation, tuple(names.split()), tuple(kinds.split()), what, route,
                           tuple(own[1].split()) if len(own) > 1 else (), tuple(also.split())))
    return out


# By the stress route the program answers (13) from (12), so that one line makes both wrong.
SHEAR = "12.epsilon_f 13.epsilon_3"
INTEGRALS = "18.U 21.K_1 21.K_2 21.K_3"

BEAM = [
    *_of("A.1", "", [
        ("A1-rx-no-two", "factor missing", "a_4 x in place of 2 a_4 x in r_x", "A.1.r_x"),
        ("A1-ry-no-square", "missing", "the term of a_6 is left out of r_y", "A.1.r_y"),
    ]),
    *_of("A.2", "A.2.e", [
        ("A2-slope-at-end", "other node-order", "r_x asked for at l in place of l/2"),
    ]),
    *_of("A.3", "A.3.coefficients", [
        ("A3-printed", "erratum", "a_1 as printed (E1)"),
        ("A3-a4-over-l", "missing factor", "a_4 divided by l in place of l squared"),
        ("A3-a6-sign", "sign", "r_y_k in a_6 with the wrong sign"),
    ]),
    *_of("A.4", "A.4.r", [
        ("A4-rj-slope-no-l", "missing factor", "b in place of l b at r_y_j"),
        ("A4-last-left-out", "missing", "the sum ends one vector early"),
    ]),
    *_of("1", "1.r", [
        ("1-x-twice", "other xy-order", "the first component is copied to the second"),
        ("1-of-start", "other", "e0 in place of e"),
    ]),
    *_of("2", "2.S", [
        ("2-blocks", "xy-order", "columns for all x, then for all y"),
        ("2-second-row", "xy-order other", "the second row is in the columns of x"),
    ]),
    *_of("3", "3.S", [
        ("3-origin-in-middle", "other", "x counted from the middle", "3.S 3.S_x 3.S_y", "origin middle"),
        ("3-float-ratio", "digits", "a = x/l in single precision", "3.S 3.S_x 3.S_y"),
        ("3-s3-s6-exchanged", "node-order", "S_3 and S_6 exchanged", "3.S 3.S_x"),
        ("3-s1-six", "factor", "6 a^2 in place of 8 a^2 in S_1", "3.S 3.S_x"),
        ("3-s6-sign", "sign", "+4 a^2 in S_6", "3.S 3.S_x"),
        ("3-s2-square-lost", "other factor missing", "2 a in place of 2 a^2 in S_2", "3.S 3.S_x 3.S_y"),
        ("3-s7-factor", "factor", "4 a^2 in place of 2 a^2 in S_7", "3.S 3.S_x 3.S_y"),
        ("3-s4-no-l", "missing factor", "l left out of S_4", "3.S 3.S_x"),
        ("3-slopes-no-l", "missing factor", "b in place of l b in S_2, S_5, S_7", "3.S 3.S_x 3.S_y"),
        ("3-no-chain-rule", "missing factor", "derivatives by a taken for those by x", "3.S_x"),
        ("3-s4-product-rule", "missing other", "half of the product rule in the derivative of S_4", "3.S_x"),
        ("3-s5-copied", "missing other", "derivative of S_3 copied to S_5, without y", "3.S_x"),
        ("3-s1x-power", "factor", "the power of a^3 forgotten in the derivative of S_1", "3.S_x"),
        ("3-s2y-keeps-y", "factor other", "y kept in the derivative of S_2 by y", "3.S_y"),
        ("3-sy-loop-short", "missing", "the loop over derivatives by y ends at 6", "3.S_y"),
        ("3-sy-of-sx", "other", "4 - 8 a for the derivative of S_5 by y", "3.S_y"),
    ]),
    *_of("4", "4.nodes", [
        ("4-all-x-first", "xy-order", "e read as all x, then all y"),
        ("4-j-before-slope", "node-order", "r_y_i and r_j exchanged"),
        ("4-x-and-y-slope", "node-order", "r_x_j and r_y_j exchanged"),
    ]),
    *_of("5", "5.rdot", [
        ("5-first-point", "other", "shape functions of the first point at all points", "5.rdot", "point"),
        ("5-of-e", "other", "e in place of its rate"),
        ("5-plus-position", "other", "the x of the position added: a variable not cleared"),
    ]),
    *_of("6", "6.T", [
        ("6-no-half", "factor missing", "1/2 left out"),
        ("6-diagonal", "missing other", "the diagonal of M only"),
        ("6-x-only", "missing other", "velocity along x only"),
    ]),
    *_of("7", "7.M", [
        ("7-three-points", "quadrature", "three Gauss points along: degree 6 needs four"),
        ("7-no-rotary", "quadrature missing", "one Gauss point across: no inertia of rotation"),
        ("7-h-w-exchanged", "other", "h and w exchanged", "7.M", "exchanged"),
        ("7-no-width", "missing factor", "w left out"),
        ("7-jacobian-l", "factor", "l in place of l/2 in the weights"),
        ("7-weight", "factor", "weight in place of mass"),
        ("7-length-now", "other factor", "the present length in place of l", "7.M", "current present"),
        ("7-upper-only", "missing other", "only the upper triangle filled"),
        ("7-lumped", "other", "rows summed up on the diagonal", "7.M", "lumped diagonal"),
        ("7-all-components", "other xy-order", "S_a S_b between x and y too"),
    ]),
    *_of("8", "8.epsilon_T", [
        ("8-kelvin", "heat", "the absolute temperature in place of its change"),
        ("8-absolute", "heat sign", "|dT|: cooling expands"),
        ("8-twice-alpha", "heat factor", "2 alpha dT"),
        ("8-stretch-squared", "heat other", "((1 + alpha dT)^2 - 1)/2"),
        ("8-model-ignored", "heat", "2d whatever the model"),
        ("8-2d-as-1d", "heat missing", "1d for 2d"),
        ("8-shear", "heat-on-shear", "alpha dT in the shear as well"),
        ("8-plane-strain", "heat poisson factor", "(1 + nu) alpha dT, plane strain's expansion"),
        ("8-across-only", "heat missing", "2d: the first component forgotten"),
        ("8-along-x", "heat-along-x", "1d: along the global x"),
        ("8-1d-as-vector", "heat other", "1d: (cos, sin, 0), turned as a vector"),
        ("8-1d-shear-sign", "sign heat", "1d: shear with the wrong sign"),
        ("8-1d-shear-twice", "factor heat", "1d: engineering shear, by halves"),
        ("8-1d-no-shear", "missing heat", "1d: no shear"),
        ("8-1d-sin-cos", "sin-cos", "1d: sine and cosine exchanged"),
    ]),
    *_of("9", "9.J", [
        ("9-J0-of-e", "other", "J_0 from e in place of e0", "9.J_0"),
        ("9-J0-rows", "transpose", "J_0 transposed", "9.J_0"),
        ("9-not-inverted", "transpose other missing", "J_0 in place of its inverse"),
        ("9-no-J0", "missing", "J_0 left out"),
        ("9-inverse-no-signs", "sign", "the inverse without its minus signs"),
        ("9-inverse-one-sign", "sign", "the inverse with one minus sign only"),
        ("9-order", "other transpose", "the inverse on the left"),
        ("9-transposed", "transpose", "J transposed"),
    ]),
    *_of("10", "10.epsilon_m", [
        ("10-J-Jt", "transpose other", "J J^T in place of J^T J"),
        ("10-no-half", "factor missing", "1/2 left out"),
        ("10-linear", "other missing", "the linear strain"),
        ("10-one-everywhere", "other", "1 subtracted from all entries"),
        ("10-one-once", "missing", "1 subtracted from the first entry only"),
        ("10-half-of-J", "factor other", "1/2 J^T J - I"),
    ]),
    *_of("11", "", [
        ("11-minus-theta", "sign sin-cos", "-theta", "11.S_a 11.S_b 11.S_c"),
        ("11-degrees", "other", "theta taken for degrees", "11.S_a 11.S_b 11.S_c", "degree unit"),
        ("11-theta-now", "other", "the present angle of the chord", "11.S_a 11.S_b 11.S_c", "current present"),
        ("11-sa-sin-cos", "sin-cos", "sine and cosine exchanged in S_a", "11.S_a"),
        ("11-sa-cross-once", "missing", "one of the two mixed terms of S_a left out", "11.S_a"),
        ("11-sa-cos-not-squared", "other factor missing", "cos in place of cos^2 in S_a", "11.S_a"),
        ("11-sb-cross-sign", "sign", "signs of S_a copied to S_b", "11.S_b"),
        ("11-sb-no-yy", "missing", "last term of S_b left out", "11.S_b"),
        ("11-sc-no-yy", "missing", "last term of S_c left out", "11.S_c"),
        ("11-sc-squares-exchanged", "sin-cos", "sin^2 and cos^2 exchanged in S_c", "11.S_c"),
        ("11-sc-sign", "sign", "third term of S_c with the wrong sign", "11.S_c"),
        ("11-first-row-only", "missing other", "the sum over the rows of S ends at 1", "11.S_a 11.S_b 11.S_c"),
        ("11-sc-plus-transpose", "factor other transpose", "S_c + S_c^T without 1/2", "11.S_c"),
    ], "paper"),
    *_of("12", "12.epsilon_f", [
        ("12-shear-twice", "factor", "2 epsilon_12, but D for epsilon_12", SHEAR),
        ("12-order", "xy-order other", "(11, 12, 22), but D for (11, 22, 12)", SHEAR + " 13.epsilon_2", "order voigt"),
        ("12-shear-minus", "sign", "shear with the wrong sign", SHEAR),
    ]),
    *_of("13", "", [
        ("13-second-copied", "other", "S_a in epsilon_2: copied", "13.epsilon_2"),
        ("13-half-of-first", "factor other", "1/2 e^T S_a e - 1", "13.epsilon_1"),
        ("13-shear-no-half", "factor missing", "1/2 left out of epsilon_3", "13.epsilon_3"),
        ("13-shear-one", "other erratum", "1 subtracted from epsilon_3 too", "13.epsilon_3"),
    ], "paper"),
    *_of("14", "14.epsilon", [
        ("14-plus", "sign", "heat added"),
        ("14-twice", "factor heat", "heat subtracted twice"),
        ("14-first-only", "heat missing", "heat subtracted from the first component only"),
        ("14-no-shear", "heat missing", "1d: heat not subtracted from the shear"),
    ]),
    *_of("15", "15.sigma", [
        ("15-no-heat", "heat missing", "the whole strain"),
        ("15-shear-half", "factor", "mu epsilon_12"),
        ("15-overwritten", "missing other", "= in place of += for the second component"),
    ]),
    *_of("16", "16.D", [
        ("16-shear-mu", "factor", "mu for 2 mu: engineering shear, by halves"),
        ("16-shear-four-mu", "factor", "4 mu for 2 mu"),
        ("16-upper-only", "missing", "D_21 left zero"),
        ("16-diagonal-mu", "factor", "lambda + mu"),
        ("16-no-lambda", "missing", "2 mu on the diagonal"),
        ("16-no-coupling", "missing poisson", "D_12 = D_21 = 0"),
        ("16-coupling-mu", "other poisson", "mu for lambda beside the diagonal"),
        ("16-plane-stress", "other poisson", "plane stress"),
    ]),
    *_of("17", "", [
        ("17-nu-steel", "poisson other", "nu = 0.3 whatever the state says", "17.lambda 17.mu"),
        ("17-nu-left-out", "poisson missing", "nu = 0", "17.lambda 17.mu"),
        ("17-nu-absolute", "poisson sign", "|nu|", "17.lambda 17.mu"),
        ("17-lambda-precedence", "poisson other factor", "E nu / (1 + nu) * (1 - 2 nu)", "17.lambda"),
        ("17-lambda-plane-stress", "poisson other", "E nu / (1 - nu^2)", "17.lambda"),
        ("17-lambda-no-nu", "poisson missing", "nu left out above the line", "17.lambda"),
        ("17-mu-no-two", "factor missing", "E / (1 + nu)", "17.mu"),
        ("17-mu-precedence", "poisson other factor", "E / 2 * (1 + nu)", "17.mu"),
        ("17-mu-minus", "sign poisson", "E / (2 (1 - nu))", "17.mu"),
        ("17-mu-half-E", "missing poisson", "E / 2", "17.mu"),
    ]),
    *_of("18", INTEGRALS, [
        ("18-four-along", "quadrature", "four Gauss points along"),
        ("18-three-along", "quadrature", "three Gauss points along"),
        ("18-two-along", "quadrature", "two Gauss points along"),
        ("18-two-across", "quadrature", "two Gauss points across"),
        ("18-axis-only", "quadrature", "one Gauss point across: no bending"),
        ("18-centred-points", "quadrature", "points from -l/2 to l/2"),
        ("18-unscaled-y", "quadrature factor", "points at +-h in place of +-h/2"),
        ("18-weights-exchanged", "quadrature factor", "5/9 and 8/9 exchanged", INTEGRALS + " cable.U"),
        ("18-middle-weight", "quadrature factor", "128/255 for 128/225", INTEGRALS + " cable.U"),
        ("18-no-width", "missing factor", "w left out"),
        ("18-jacobian-h", "factor", "h in place of h/2 in the weights"),
        ("E3-own-axes", "erratum factor", "E3 in the rod's own axes, theta ignored", INTEGRALS + " 20.K"),
    ], also="19.Q_e tangent.dQ_e"),
    *_of("18", "18.U", [
        ("18-strain-with-heat", "heat missing", "the whole strain times the stress"),
        ("18-integer-half", "missing factor", "1/2 in integers: zero"),
        ("18-no-half", "missing factor", "1/2 left out"),
        ("E3-energy", "erratum", "shear counted once in energy, force, K and tangent (E3)", "18.U 20.K"),
    ]),
    *_of("19", "19.Q_e", [
        ("19-at-start", "other missing", "the strain's derivative at the start: linear"),
        ("19-shear-half-missing", "missing other", "one of the two terms in the shear's derivative"),
        ("19-shear-engineering", "factor", "derivative of 2 epsilon_12, counted twice"),
        ("19-J-transposed", "transpose other", "J transposed in the strain's derivative"),
        ("19-no-heat", "heat missing", "the stress without heat in the force only"),
        ("19-no-shear", "missing", "shear left out of the force"),
        ("19-minus", "sign", "the force of the rod on the nodes, for the other side of (22)"),
        ("19-half", "factor", "half"),
    ]),
    *_of("19", "19.Q_e", [
        ("19-displacement", "other", "K (e - e0)"),
        ("19-K-of-start", "other", "K e0"),
    ], "paper"),
    *_of("20", "20.K", [
        ("20-printed", "erratum", "2 mu K_3 as printed (E3)"),
        ("20-exchanged", "other", "the factors of K_1 and K_2 exchanged"),
        ("20-one-mu", "factor", "lambda + mu"),
        ("20-minus", "sign", "-lambda K_2"),
        ("20-no-k3", "missing", "K_3 left out"),
        ("20-k2-mu", "other poisson", "mu K_2"),
    ], "paper"),
    *_of("21", "", [
        ("21-not-added", "missing factor", "S_a1 = S_a^T and so on", "21.S_a1 21.S_b1 21.S_c1"),
        ("21-sc1-twice", "other transpose factor", "2 S_c for S_c + S_c^T", "21.S_c1"),
        ("21-sb1-minus", "sign", "S_b - S_b^T", "21.S_b1"),
        ("21-heat-once", "factor heat", "alpha dT for 2 alpha dT", "21.K_1 21.K_2 21.K_3"),
        ("21-heat-plus", "sign heat", "+2 alpha dT", "21.K_1 21.K_2 21.K_3"),
        ("21-k2-no-heat", "heat missing", "no heat in K_2", "21.K_2"),
        ("21-k1-heat-on-a-only", "heat missing", "no heat with S_b1 in K_1", "21.K_1"),
        ("21-k3-no-heat", "heat missing", "1d: no heat in K_3", "21.K_3"),
        ("21-k3-printed", "erratum", "K_3 as printed (E2)", "21.K_3"),
        ("21-1d-heat-even", "heat", "1d: alpha dT in both directions, as printed for 2d", "21.K_1 21.K_2 21.K_3"),
        ("21-no-one", "missing", "-1 left out with S_b", "21.K_1 21.K_2"),
        ("21-k3-half", "factor", "1/2 for 1/4 in K_3", "21.K_3"),
        ("21-no-quarter", "missing factor", "1/4 left out", "21.K_1 21.K_2 21.K_3"),
        ("21-k2-copied", "other", "K_1 copied to K_2", "21.K_2"),
        ("21-k2-first-term", "missing", "second term of K_2 left out", "21.K_2"),
    ], "paper"),
    *_of("tangent", "tangent.dQ_e", [
        ("tangent-shear-once", "factor", "shear counted once in the material part"),
        ("tangent-heat-left-out", "heat missing", "geometric part with the stress without heat"),
        ("tangent-no-coupling", "missing poisson", "D_12 left out of the material part"),
        ("tangent-geometric-no-shear", "missing", "shear stress left out of the geometric part"),
        ("tangent-no-geometric", "missing", "the geometric part left out"),
        ("tangent-geometric-sign", "sign", "the geometric part with the wrong sign"),
        ("tangent-upper-only", "missing other", "only the upper triangle filled"),
    ]),
    *_of("tangent", "tangent.dQ_e", [
        ("tangent-secant", "missing other", "K for the tangent"),
        ("tangent-half", "factor", "1/2 for 1/4 in the derivative of K"),
        ("tangent-k2-one-term", "missing", "one of the two terms of K_2's derivative"),
    ], "paper"),
    *_of("gravity", "gravity.Q_w", [
        ("gravity-y-only", "missing", "g along y only"),
        ("gravity-minus", "sign", "g upwards"),
        ("gravity-9.81", "factor other", "9.81 in place of 9.8"),
        ("gravity-own-axes", "other sin-cos", "g turned to the rod's axes", "gravity.Q_w", "axes"),
        ("gravity-no-width", "missing factor", "w left out"),
        ("gravity-one-point", "quadrature", "one Gauss point along"),
        ("gravity-half-to-each-end", "other", "half the weight at each end", "gravity.Q_w", "lumped"),
        ("gravity-nodes-exchanged", "node-order", "places of j and k exchanged"),
    ]),
    *_of("22", "22.eddot", [
        ("22-plus-force", "sign", "M eddot = Q_w + Q_e"),
        ("22-no-weight", "missing", "Q_w left out"),
        ("22-no-force", "missing", "Q_e left out"),
        ("22-diagonal", "other missing", "divided by the diagonal of M", "22.eddot", "diagonal lumped"),
        ("22-not-solved", "other", "multiplied by M in place of solved"),
        ("22-residual-of-e", "other", "M e in place of M a", "22.residual"),
        ("22-residual-weight-sign", "sign", "+Q_w", "22.residual"),
        ("22-residual-no-inertia", "missing", "M a left out", "22.residual"),
    ]),
    *_of("23", "", [
        ("E4-printed", "erratum transpose", "Phi_q lambda (E4), read from one list", "23.constraint_force"),
        ("23-last-constraint", "missing", "the loop over constraints ends one early", "23.constraint_force"),
        ("23-force-minus", "sign", "-Phi_q^T lambda", "23.constraint_force"),
        ("23-residual-sign", "sign", "-Phi_q^T lambda in the residual", "23.residual"),
        ("23-residual-load-sign", "sign", "+f", "23.residual"),
        ("23-residual-no-force", "missing", "Q_e left out", "23.residual"),
        ("23-solve-no-force", "missing", "Q_e left out of the solution", "23.acceleration 23.lambda"),
        ("23-solve-plus-force", "sign", "+Q_e in the solution", "23.acceleration 23.lambda"),
        ("23-lambda-minus", "sign", "-lambda", "23.lambda"),
    ]),
]

CABLE = [
    *_of("cable", "", [
        ("c-s2-sign", "sign", "+2 a^2 in S_2", "cable.S cable.S_x cable.S_xx"),
        ("c-s4-no-minus", "sign", "+a^2 in S_4", "cable.S cable.S_x cable.S_xx"),
        ("c-slopes-no-l", "missing factor", "l left out of S_2 and S_4", "cable.S cable.S_x cable.S_xx"),
        ("c-sxx-one-l", "missing factor", "1/l for 1/l^2 in the second derivative", "cable.S_xx"),
        ("c-heat-plus", "sign heat", "heat added", "cable.epsilon", "thermal"),
        ("c-heat-missing", "heat missing", "heat left out", "cable.epsilon", "thermal"),
        ("c-heat-half", "factor heat", "alpha dT/2", "cable.epsilon", "thermal"),
        ("c-heat-always", "heat", "heat with the model none", "cable.epsilon", "thermal"),
        ("c-heat-plane-strain", "heat poisson", "(1 + nu) alpha dT", "cable.epsilon", "thermal"),
        ("c-heat-2d-only", "heat", "no heat with the model 1d", "cable.epsilon", "thermal"),
        ("c-green-lagrange", "other", "(|r_x|^2 - 1)/2", "cable.epsilon", "green strain"),
        ("c-stretch-free", "other heat", "|r_x|/(1 + alpha dT) - 1", "cable.epsilon", "thermal"),
        ("c-kappa-sign", "sign", "clockwise curvature", "cable.kappa", "curvature"),
        ("c-kappa-not-divided", "missing other", "r_x cross r_xx", "cable.kappa", "curvature"),
        ("c-kappa-cubed", "other factor", "divided by |r_x|^3: spatial curvature", "cable.kappa", "curvature"),
        ("c-kappa-second-derivative", "other", "|r_xx|", "cable.kappa", "curvature"),
        ("c-energy-no-half", "missing factor", "1/2 left out", "cable.U"),
        ("c-force-minus", "sign", "-Q_e", "cable.Q_e"),
        ("c-tangent-no-geometric", "missing", "second derivatives of strain and curvature left out", "cable.tangent"),
        ("c-mass-no-area", "missing factor", "A left out", "cable.M"),
        ("c-mass-height-twice", "other factor", "rho h^2", "cable.M"),
        ("c-mass-three", "quadrature", "three Gauss points: degree 6 needs four", "cable.M", "integration"),
        ("c-kinetic-no-half", "missing factor", "1/2 left out", "cable.T"),
        ("c-weight-lumped", "other", "half the weight at each end", "cable.Q_w", "lumped"),
        ("c-weight-minus", "sign", "g upwards", "cable.Q_w"),
        ("c-plus-force", "sign", "M eddot = Q_w + Q_e", "cable.eddot"),
    ]),
    *_of("cable", "", [
        ("c-area-square", "other factor", "A = h^2", "cable.U"),
        ("c-inertia-w-h", "other factor", "I = h w^3/12", "cable.U"),
        ("c-inertia-three", "factor", "I = w h^3/3", "cable.U"),
        ("c-inertia-no-twelve", "missing factor", "I = w h^3", "cable.U"),
        ("c-axial-three", "quadrature", "three Gauss points for the axial part", "cable.U", "integration"),
        ("c-axial-one", "quadrature", "one Gauss point for the axial part", "cable.U", "integration"),
        ("c-bending-two", "quadrature", "two Gauss points for bending", "cable.U", "integration"),
        ("c-bending-five", "quadrature", "five Gauss points for bending", "cable.U", "integration"),
        ("c-reduced", "quadrature", "four and two points: Exudyn's reduced order", "cable.U", "integration"),
        ("c-plane-strain", "poisson factor other", "E/(1 - nu^2)", "cable.U"),
    ], also="cable.Q_e cable.tangent"),
]

MISTAKES = BEAM + CABLE
BY_NAME = {mistake.name: mistake for mistake in MISTAKES}

# Two mistakes at once that show in different states or different quantities.
PAIRS = [
    ("8-plane-strain", "17-lambda-precedence"),
    ("8-along-x", "17-mu-minus"),
    ("3-s4-no-l", "gravity-minus"),
    ("8-1d-shear-sign", "16-plane-stress"),
    ("7-three-points", "19-no-heat"),
    ("11-sc-sign", "gravity-y-only"),
    ("9-no-J0", "8-absolute"),
    ("tangent-no-geometric", "7-no-rotary"),
    ("21-k3-no-heat", "17-nu-absolute"),
    ("A3-printed", "8-shear"),
    ("c-heat-plus", "c-kappa-cubed"),
    ("c-reduced", "c-weight-minus"),
    ("22-plus-force", "8-kelvin"),
    ("E4-printed", "3-s2-square-lost"),
    ("6-no-half", "15-shear-half"),
]

# Right programs with another convention in their answers: words of which the report's `conventions` has to have one.
CONVENTIONS = {
    "by-kind": ("order", "kind"),
    "ends-first": ("order", "ends"),
    "x-then-y": ("all x", "x first", "x then y", "x-then-y"),
    "slopes-xi-eta": ("xi", "eta", "ξ", "η"),
    "engineering-shear": ("engineering", "2 epsilon", "gamma", "twice"),
    "order-11-12-22": ("11, 12, 22", "voigt", "order"),
    "symmetric-S_c": ("symmetri",),
    "U-without-constant": ("constant",),
    "column-major": ("column",),
    "heat-in-law": ("law", "heat"),
}

# The same where the program reads e0, e and edot, or theta, in its convention too; the kit has to send them so.
CONVENTIONS_IN = ("by-kind", "ends-first", "x-then-y", "slopes-xi-eta", "degrees")

# Right programs of little precision.
PRECISIONS = {
    "float": ["--float"],
    "float, paper's route": ["--float", "--route", "paper"],
    "six digits": ["--print", "6"],
    "four digits": ["--print", "4"],
    "eight digits": ["--print", "8"],
    "six decimals": ["--fixed", "6"],
    "float, six digits": ["--float", "--print", "6"],
}

MEMORIES = (
    "mass-of-first-state",
    "rotation-by-length",
    "force-buffer",
    "heat-of-previous",
    "counter",
    "points-of-first-length",
    "start-of-first-state",
    "material-of-first-state",
)

# Bad formats: words that the report has to have (a quoted line has none of them), or None
# where the program has to pass all the same.
TALKS = {
    "no-flush": r"flush",
    "pretty": r"several lines|pretty|more than one line|line by line",
    "leading-dot": r"leading (dot|point)|before the (dot|point)|zero before",
    "trailing-dot": r"trailing (dot|point)|after the (dot|point)",
    "fortran": r"(?i)fortran|exponent D|D exponent|letter D",
    "plus": r"plus sign|leading (plus|\+)",
    "trailing-comma": r"comma",
    "nan": r"NaN",
    "banner": None,
    "debugging": None,
}

# Mistakes with which `given` is tried: announced and ignored, announced and read.
GIVEN = ("10-no-half", "16-shear-mu", "20-printed", "12-shear-twice", "11-sc-sign", "9-no-J0", "17-mu-no-two")
