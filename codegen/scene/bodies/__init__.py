"""Bodies of several degrees of freedom with contacts: data, laws, checks."""
