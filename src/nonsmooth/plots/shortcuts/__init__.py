"""Pictures of the paper's oscillator, with its markers."""
