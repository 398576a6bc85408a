"""The kinds of things that stand in a workspace, as convex pieces, and where they are put.

In: measures [m]. Out: bodies.
Reads no file.
"""
