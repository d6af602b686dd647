"""The flow of a linear phase in closed form, and the exact equations of a cell."""
