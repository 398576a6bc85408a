"""Rooms that are asleep: they have no process, and wake exactly as they were.

In: that a room is to sleep or wake. Out: a session that has ended or begins, with nothing lost.
Knows no policy: when a room sleeps is for others to say.
"""
