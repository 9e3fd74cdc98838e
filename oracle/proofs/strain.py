"""The strains (9)-(14) of an element at any inclination theta."""

import sympy
from sympy import cos, expand, simplify, sin, sqrt

theta = sympy.symbols("theta", real=True)
alpha_dT = sympy.symbols("alpha_dT", positive=True)
R = sympy.Matrix([[cos(theta), -sin(theta)], [sin(theta), cos(theta)]])
I = sympy.eye(2)


def printed_forms_of_the_metric_hold():
    """(11) as printed gives J^T J, with S_c in the order that (10) needs.

    Two fields have the gradients G and H in x and y: S_ix e = G_i1, S_iy e = G_i2, S_ix f = H_i1, S_iy f = H_i2.
    """
    G = sympy.Matrix(2, 2, sympy.symbols("g_1x g_1y g_2x g_2y"))
    H = sympy.Matrix(2, 2, sympy.symbols("h_1x h_1y h_2x h_2y"))
    c, s = cos(theta), sin(theta)

    def printed(xx, xy, yx, yy):
        weights = sympy.Matrix([[xx, xy], [yx, yy]])
        return sum((G[i, :] * weights * H[i, :].T)[0] for i in range(2))

    metric = (G * R.T).T * (H * R.T)
    assert expand(printed(c * c, -s * c, -s * c, s * s) - metric[0, 0]) == 0
    assert expand(printed(s * s, s * c, s * c, c * c) - metric[1, 1]) == 0
    assert expand(printed(s * c, c * c, -s * s, -s * c) - metric[0, 1]) == 0
    assert expand(metric[0, 1] - metric[1, 0]) != 0
    return "(11): S_a, S_b and S_c are right as printed; S_c is not symmetric"


def thermal_stretch_is_a_root():
    """The stress-free stretch is sqrt(1 + 2 alpha dT), not 1 + alpha dT.

    Heat is subtracted from the Green-Lagrange strain and so determines the square of the stretch: in both directions in
    the 2D model, along the initial axis in the 1D model, across it in the transverse model.
    """
    t = R[:, 0]
    root, naive = sqrt(1 + 2 * alpha_dT), 1 + alpha_dT

    def elastic(J, heat):
        return simplify((J.T * J - I) / 2 - heat)

    def both(stretch):
        return stretch * I

    def axial(stretch):
        return R * sympy.diag(stretch, 1) * R.T

    def across(stretch):
        return R * sympy.diag(1, stretch) * R.T

    for J, direction, heated in ((both, I, 2), (axial, t * t.T, 1), (across, I - t * t.T, 1)):
        assert elastic(J(root), alpha_dT * direction) == sympy.zeros(2)
        excess = elastic(J(naive), alpha_dT * direction).trace()
        assert simplify(excess) == heated * alpha_dT**2 / 2
    assert elastic(axial(root), sympy.diag(alpha_dT, 0)) != sympy.zeros(2)
    return ("the stress-free stretch is sqrt(1 + 2 alpha dT); "
            "[alpha dT, 0, 0] would be heat along x, not along the rod")
