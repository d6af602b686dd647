"""The page on one oscillator: what it is, how it moves, how fast each expansion finds it."""
