"""Loops as causes: those that never end, and those that end too soon.

In: the steps of a run, and one of them. Out: links: what was asked, by which values, and where that
came from. Knows nothing of losses.
"""
