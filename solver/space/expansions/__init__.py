"""The expansions: modes of the bare structure, with their derivatives at the attachment."""
