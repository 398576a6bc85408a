"""Convex pieces made of a mesh, once, when an author asks: the only door to CoACD.

In: triangles. Out: the text of a pieces file. Needs the packages of `vrts[mesh]`; runs do not.
Starts one process, for the library may take long or end badly; writes nothing.
"""
