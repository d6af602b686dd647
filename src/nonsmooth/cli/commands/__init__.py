"""Commands that are the same for all scenes and structures, and those of the paper alone."""
