"""What users hold of an orbit, and the document of it."""
