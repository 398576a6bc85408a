"""Robots of their own: a room for one student or one team, asleep while nobody needs it.

In: who wants which scene, who comes in, who raises a hand. Out: rooms that last for the term, put
to sleep and woken within limits, and the queue of those who wait for help. Knows no course.
"""
