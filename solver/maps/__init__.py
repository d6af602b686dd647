"""Condensation: coefficients are eliminated phase by phase, Newton's method has the rest."""
