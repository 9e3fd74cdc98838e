"""The peer program Exudyn on our scenes: how long it takes, and where it says that the structure is.

Exudyn has an element, ANCFCable2D, of the same theory as our Euler-Bernoulli element: same axis, strains and Gauss
points. So both converge to the same motion, and the time that each takes to come near it can be compared.

Nothing else of the oracle depends on this package, and it needs nothing else of the oracle.
"""
