"""Scenes of users: a file or an object is read, and its kernels are derived once and kept.

`read` runs a scene file, `content` hashes scenes, `store` keeps the kernels in the user's
cache, and `find` returns a scene from its name, path or object.
"""
