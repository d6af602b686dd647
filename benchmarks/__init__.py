"""Benchmarks: nothing here is a test, and nothing is timed by a test."""
