"""From rough times to a solution: starts, Newton's method, linear algebra."""
