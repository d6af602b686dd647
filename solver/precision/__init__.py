"""The same equations in ball arithmetic: how many digits float64 keeps of their solution."""
