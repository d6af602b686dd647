"""Maps of phases: from the state in which one begins to that in which it ends; their joints."""
