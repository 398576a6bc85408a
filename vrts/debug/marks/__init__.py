"""Places of a run that were given names, that were shown with numbers, and that links lead to.

In: instants. Out: the same ones again, exactly, or why a run does not come there any more.
"""
