"""The Euler-Bernoulli cable element, the paper's competitor: every quantity in exact states, from its field and energy."""
