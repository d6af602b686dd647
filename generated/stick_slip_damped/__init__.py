"""stick-slip-damped: a damped mass on a moving belt, with weakening friction; written by ``nonsmooth generate``."""
