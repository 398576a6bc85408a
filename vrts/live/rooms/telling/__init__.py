"""Who is told what in a room, and what those who come back have missed.

In: messages with their numbers. Out: frames for those who are meant.
"""
