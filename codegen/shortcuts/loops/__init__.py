"""The loops of these kernels over their indices, as text."""
