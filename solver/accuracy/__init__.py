"""How far an orbit of a scene is from the exact one: errors, and estimates without it."""
