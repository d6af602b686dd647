"""Columns of the arrays in `Rules`."""

#: Of `phases`; the factors of the memory are behind them.
M, C, K, F, G, SPEED, RHO, D, MEMORY = range(9)

#: Of `kinds`.
HELD, WATCHED, WALL, INDEX, SIGN, ROW, AT_SWITCH, END = range(8)

#: In the place of a phase or of a surface: there is none.
NONE = -1
