"""Columns of the arrays in `Rules`."""

#: Of `phases`; from `MEMORY` on, the coefficients of the memory.
M, C, K, F, G, SPEED, RHO, D, MEMORY = range(9)

#: Of `kinds`.
HELD, WATCHED, WALL, LAW, ROW, AT_SWITCH, END = range(7)

#: Number that stands for no phase, or no surface.
NONE = -1
