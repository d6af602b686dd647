"""Fourier series: a million harmonics without a matrix, errors summed over harmonics."""
