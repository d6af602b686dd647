"""A scene in words and formulas, read from its generated module: no SymPy is needed."""
