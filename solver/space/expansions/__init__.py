"""The expansions: each a set of modes of the bare structure, and what is felt of them."""
