"""Bodies with a contact: the exact orbit and the force series beside other codes."""
