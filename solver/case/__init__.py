"""A scene with numbers: its generated modules, checked parameters, units, kernels."""
