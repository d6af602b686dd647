"""What the program said when it was last looked at closely: `python -m frozen` in `tests/`."""

import os

# Before NumPy, as the tests have it: with several threads BLAS adds up in another order.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
