"""The oracle: what the paper's equations and motions are, from energies, fields and constraint functions."""

import os

# The matrices are small: threads would cost more than they bring. Has to be said before numpy is loaded.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
