"""Section 3.3 as one scalar equation, for any order."""
