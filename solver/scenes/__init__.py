"""A scene as it is loaded, and with numbers: a case, its units, the equations of its cell."""
