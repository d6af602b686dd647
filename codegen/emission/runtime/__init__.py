"""Functions that kernels call besides their closed forms: real code, copied into each module."""
