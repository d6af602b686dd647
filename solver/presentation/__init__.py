"""What every result can do: draw itself, become a table, show itself in a notebook."""
