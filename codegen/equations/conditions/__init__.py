"""The conditions of a scene in an expansion, to be printed; a file for each family of them."""
