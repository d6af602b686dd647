"""The page on one oscillator: its motion, and how fast each expansion converges to it."""
