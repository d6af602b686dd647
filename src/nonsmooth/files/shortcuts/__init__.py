"""Files of the paper's oscillator: orbits, sweeps and families as JSON, netCDF, CSV."""
