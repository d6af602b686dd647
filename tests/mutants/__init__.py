"""Mutation tests: `python -m mutants`, from the folder of the tests, or `make mutants`."""
