"""Identities of mechanics for the solid, asserted before anything is computed with it."""

from itertools import product

import numpy as np
import scipy
import skfem

from ..motion.beam import stress_and_energy
from .solid import Rod, Solid, motion

ROD = Rod(L=1.0, h=0.02, w=0.02, rho=7750.0, E=2e8, g=9.8)
HEAT = [[1.0, 1.0114, 1.0114], [1.0, 1.0, 1.0114]]
ROUNDING = 1e-11  # fraction of E h w, for strains of order one

ELEMENTS = (skfem.ElementQuad2, skfem.ElementQuadS2)


def demand():
    """Runs every check with 9 and 8 nodes; a failed assertion ends the program."""
    for element, across in product(ELEMENTS, (2, 4)):
        solid = Solid(ROD, 4, across, HEAT, element)
        demand_patch(solid)
        demand_free_expansion(solid)
        demand_frame(solid)
        demand_energy(solid)
        demand_mass(solid)
    demand_step_limit()
    demand_bending()
    demand_balance()


def bent(solid):
    """A rotated state without symmetry, equal for all models, with strains of a few per cent."""
    x, y = solid.initial
    c, s = np.cos(0.7), np.sin(0.7)
    shape = np.array([x + 0.02 * x**2 - y * x, y * (1 + 0.03 * x) + 0.1 * x**2])
    return np.repeat((np.array([[c, -s], [s, c]]) @ shape)[:, :, None], solid.models, 2)


def size(solid):
    """Force scale E h w."""
    return solid.rod.E * solid.rod.h * solid.rod.w


def demand_patch(solid):
    """Patch test: under a uniform gradient inner nodes are free of force and the boundary carries the law's stress."""
    F = np.array([[0.9, -0.4], [0.5, 1.1]])
    force = solid.force(np.repeat((F @ solid.initial)[:, :, None], solid.models, 2))
    x, y = solid.initial
    inside = (x > 1e-9) & (x < solid.rod.L - 1e-9) & (abs(y) < solid.rod.h / 2 - 1e-9)
    assert inside.any() and abs(force[:, inside]).max() < ROUNDING * size(solid)
    stress, _, _ = stress_and_energy(0)
    volume = solid.rod.L * solid.rod.h * solid.rod.w
    for model, C_T in enumerate(np.transpose(HEAT)):
        expected = -solid.mu * volume * np.reshape(stress(*F.ravel(), *C_T), (2, 2))
        found = force[:, :, model] @ solid.initial.T
        assert np.allclose(found, expected, rtol=0, atol=ROUNDING * solid.mu * volume)


def demand_free_expansion(solid):
    """Free expansion: no force at the rotated stress-free stretch, a force at the unstretched heated rod."""
    c, s = np.cos(2.0), np.sin(2.0)
    free = np.einsum("ij,jnm->inm", [[c, -s], [s, c]], solid.straight(*np.sqrt(HEAT)))
    assert abs(solid.force(free)).max() < ROUNDING * size(solid)
    cold, hot_1d, hot_2d = abs(solid.force(solid.straight(*np.ones((2, 3))))).max((0, 1))
    assert cold < ROUNDING * size(solid) and min(hot_1d, hot_2d) > 1e-4 * size(solid)


def demand_frame(solid):
    """Frame indifference: forces rotate with the rod and have neither resultant nor moment."""
    r = bent(solid)
    c, s = np.cos(1.1), np.sin(1.1)
    turn = np.array([[c, -s], [s, c]])
    force, turned = solid.force(r), solid.force(np.einsum("ij,jnm->inm", turn, r))
    assert abs(turned - np.einsum("ij,jnm->inm", turn, force)).max() < ROUNDING * size(solid)
    assert abs(force.sum(1)).max() < ROUNDING * size(solid)
    assert abs((r[0] * force[1] - r[1] * force[0]).sum(0)).max() < ROUNDING * size(solid) * solid.rod.L


def demand_energy(solid):
    """Energy: the force is minus the derivative of the strain energy (central difference)."""
    r = bent(solid)
    direction = np.random.default_rng(1).normal(size=r.shape) * solid.rod.h
    step = 1e-5
    up, down = (solid.energies(r + sign * step * direction, np.zeros_like(r))[1] for sign in (1, -1))
    work = (solid.force(r) * direction).sum((0, 1))
    assert np.allclose((down - up) / (2 * step), work, rtol=1e-6, atol=0)


def demand_mass(solid):
    """Mass: total, centre, and a positive mass for every node."""
    rod = solid.rod
    assert solid.mass.min() > 0 and np.isclose(solid.mass.sum(), rod.rho * rod.L * rod.h * rod.w, rtol=ROUNDING)
    assert np.allclose(solid.initial @ solid.mass / solid.mass.sum(), [rod.L / 2, 0], rtol=0, atol=ROUNDING)


def stiffness(solid):
    """Stiffness of the rod at rest from displacements of both signs and two sizes; the force is cubic in them.

    Even powers cancel in the differences and the cubic term in their combination, so that displacements need not be small.
    """
    rest = solid.initial.ravel()
    size = solid.rod.h / 10

    def difference(displacement):
        up, down = (rest[:, None] + sign * displacement * np.eye(rest.size) for sign in (1, -1))
        force = solid.force(down.reshape(2, -1, rest.size)) - solid.force(up.reshape(2, -1, rest.size))
        return force.reshape(rest.size, -1) / 2

    return (8 * difference(size) - difference(2 * size)) / (6 * size)


def unheated(along, across):
    """A rod of 9-node elements without heat, with one model per coordinate: one call displaces each coordinate once."""
    count = 2 * (2 * along + 1) * (2 * across + 1)
    return Solid(ROD, along, across, np.ones((2, count)))


def demand_step_limit():
    """Step limit: on a regular mesh that of a single element is that of the whole mesh."""
    solid = unheated(8, 2)
    fastest = scipy.linalg.eigh(stiffness(solid), np.diag(np.tile(solid.mass, 2)), eigvals_only=True)[-1]
    assert np.isclose(solid.stable_step(), np.sqrt(12 / fastest), rtol=1e-9)


def demand_bending():
    """Bending: the lowest frequency converges to that of plane elasticity with order 4 in length and height of the elements.

    With one element across, the shear stress is uniform over the section and too stiff, like that of a beam without a
    correction factor; two elements have 15/16 of that stiffness.
    """
    one, two, four, fine = (bending(*mesh) - 1 for mesh in ((20, 1), (20, 2), (20, 4), (40, 2)))
    assert two / fine > 10 and fine < 4e-5
    assert (one - two) / (two - four) > 10


def bending(along, across):
    """Ratio of the lowest frequency to the exact one, for ends held in height and free along the rod.

    Such a rod bends in sine waves, and its frequency solves the equation of Rayleigh and Lamb.
    """
    solid = unheated(along, across)
    c, k = solid.rod.h / 2, np.pi / solid.rod.L
    speed = np.sqrt(solid.rod.E / solid.rod.rho)  # of pressure; sqrt(2) times that of shear, as nu = 0

    def rayleigh_lamb(omega):
        P, Q = np.sqrt(k**2 - (omega / speed)**2), np.sqrt(k**2 - 2 * (omega / speed)**2)
        return 4 * k**2 * P * Q * np.tanh(Q * c) - (k**2 + Q**2)**2 * np.tanh(P * c)

    slender = k**2 * solid.rod.h * speed / np.sqrt(12)
    exact = scipy.optimize.brentq(rayleigh_lamb, 0.9 * slender, slender, xtol=1e-9)
    held = np.tile(np.isclose(abs(solid.initial[0] - solid.rod.L / 2), solid.rod.L / 2), 2)
    held[:solid.mass.size] = False
    free = np.flatnonzero(~held)
    K, mass = stiffness(solid)[np.ix_(free, free)], np.tile(solid.mass, 2)[free]
    # The first is the translation along the rod.
    return np.sqrt(scipy.linalg.eigh(K, np.diag(mass), eigvals_only=True, subset_by_index=[1, 1])[0]) / exact


def demand_balance():
    """Balance: the hinged rod conserves its energy while it falls, cold and heated along, better with smaller steps."""
    solid = Solid(ROD, 10, 2, [[1.0, 1.0114], [1.0, 1.0]])
    coarse, fine = (balance(solid, 2.5e-5 / split, 80 * split) for split in (1, 2))
    assert fine[0] < 1e-7 and fine[1] < 1e-3 and (coarse / fine > 3).all()


def balance(solid, step, every):
    """Largest change of each model's total energy over ten samples, relative to its largest kinetic energy."""
    states = motion(solid, solid.straight(*np.ones((2, 2))), step, every, 10)
    energies = np.array([solid.energies(*state) for state in states])
    return np.ptp(energies.sum(1), axis=0) / energies[:, 0].max(0)
