"""The shipped scenes of one mass: what is computed for these alone is tested on them."""

from nonsmooth.solver.kernels import registry

NAMES = tuple(name for name in registry.names() if not registry.load(name).has_body)
