"""What kernels call besides their closed forms: real functions, copied into each module."""
