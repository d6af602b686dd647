"""Orders of phases along a branch: which may follow where one ends, and how."""
