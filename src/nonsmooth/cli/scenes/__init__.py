"""Commands of any scene: built from its generated module when the scene is named.

`commands` has their help and `options` their options; `solve`, `sweep`, `digits` and the others
are what runs, of the `case` that is described.  What they print is in `tables` and `captions`.
"""
