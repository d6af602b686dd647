"""The same equations in ball arithmetic: how many digits of their solution float64 gives."""
