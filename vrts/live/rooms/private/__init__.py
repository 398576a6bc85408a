"""Rooms of one person, that go on from a moment of another room's session.

In: who wants to go on from where. Out: a room, and its end when nobody is in it for a while.
Knows nothing of how its session does again what was done: that is in its log.
"""
