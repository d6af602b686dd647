"""Stable or not: what one period of an orbit makes of small perturbations of its state."""
