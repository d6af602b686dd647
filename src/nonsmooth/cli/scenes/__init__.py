"""Commands of any scene: built from its generated module when the scene is named.

`command` looks at the first argument, `options` has the flags of a scene, `solve`, `sweep` and
`generate` are built for it, `listing` is ``nonsmooth scenes``.
"""
