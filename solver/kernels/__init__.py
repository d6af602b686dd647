"""The equations of a scene by a method, as functions of arrays, and where Newton starts."""
