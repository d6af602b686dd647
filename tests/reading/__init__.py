"""Read printed equations back: what a reader sees becomes expressions again.

`drawing` and `latex` turn a format into the tokens of `tokens`, `grammar` turns
those into expressions in the plain words of `plain`, and `compare` holds them against a record.
None of them knows the printers.
"""
