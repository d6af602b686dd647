"""Every scene, by our methods and by what one would otherwise use: time against error."""
