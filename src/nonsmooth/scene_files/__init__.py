"""Scenes of users: a file or an object is read, derived once, and kept.

`read` runs a scene file, `content` hashes what is to be derived, `store` keeps the kernels in
the user's cache, `find` takes whatever names a scene, and derives it.
"""
