"""The oracle: values of the paper's equations and motions, from energies, displacement fields and constraint functions."""

import os

# Threads cost more than they save on matrices this small. The variable must be set before numpy is imported.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
