"""What is tested against what, when, where it is then, and by which rule it may touch.

In: a run and its scene. Out: rows of pairs of convex pieces, with their distances on request.
Does not know how intervals of time are searched.
"""
