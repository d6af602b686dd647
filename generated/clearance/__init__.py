"""clearance: a driven mass with a second spring behind a clearance; written by ``nonsmooth generate``."""
