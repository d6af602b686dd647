"""jenkins-absorber: a driven mass and an absorber, joined by a spring and a slider in series; written by ``nonsmooth generate``."""
