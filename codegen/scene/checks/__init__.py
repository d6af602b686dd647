"""Checks of a scene when it is made: each error names the field that is wrong."""
