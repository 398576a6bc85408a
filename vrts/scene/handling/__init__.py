"""Where the hand can grip things and set them down.

In: a scene. Out: named locations of the hand, ways to hold things, places it can work at.
Knows no task: what is to be carried where is asked by `assignments`.
"""
