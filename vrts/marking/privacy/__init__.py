"""Marking without names, and deletion of what marking wrote about persons.

In: rows of a class, folders of markings. Out: pseudonyms, deletions, figures that name nobody.
Knows no program.
"""
