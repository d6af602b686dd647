"""Files of any scene: orbits, sweeps and families as JSON, netCDF, CSV."""
