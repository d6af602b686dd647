"""The commands of the paper's oscillator: its flags, tables, pictures, families."""
