"""The conditions of a scene in an expansion, for the reader: a file for each family of them."""
