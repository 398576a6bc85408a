"""The locations of a program as handles: where they stand, and which can be moved by their numbers.

In: a module and its run. Out: rows of plain JSON for a viewer. Opens no file.
"""
