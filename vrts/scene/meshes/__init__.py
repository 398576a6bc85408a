"""Things from mesh files: triangles, the convex pieces that stand for them, and what is proven.

In: bytes of mesh and pieces files. Out: triangles, pieces, distances between the two.
Opens no file and starts no process; the library that splits meshes is called by `pipeline.pieces`.
"""
