"""What is written on the command line for numbers: orders, times, ranges."""
