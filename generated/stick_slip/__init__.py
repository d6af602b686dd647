"""stick-slip: a mass on a moving belt, stick and slip; written by ``nonsmooth generate``."""
