"""What the error of an orbit is without the exact one, and how fast errors fall."""
