"""Files of modes: JSON, netCDF, CSV."""
