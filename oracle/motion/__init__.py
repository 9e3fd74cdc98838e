"""The pendulum of Table 1 in motion: mass, forces and energies of one rod in floating point, two integrators, the rigid limit."""
