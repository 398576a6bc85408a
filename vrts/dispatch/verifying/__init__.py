"""A bundle from somewhere else: everything in it proven again, and who has signed it.

In: the bytes of a bundle. Out: what was looked at, and what came of it.
Talks to no controller.
"""
