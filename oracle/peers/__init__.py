"""The peer program Exudyn on our scenes: its run times and its positions of the structure.

Exudyn's element ANCFCable2D has the theory of our Euler-Bernoulli element: axis, strains and Gauss points are equal.
Both converge to the same motion, so that their run times at equal errors can be compared.

This package imports no other part of the oracle, and no other part imports it.
"""
