"""Commands of any scene: built from its generated module when the scene is named.

`command` looks at the first argument, `options` has the flags of a scene; `solve`, `sweep`,
`digits` and the others are built for it.  What they print is in `shown`.
"""
