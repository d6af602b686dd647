"""Results as plots, as tables, and in notebooks."""
