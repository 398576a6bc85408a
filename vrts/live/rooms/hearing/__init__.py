"""What sessions say, handed on to the people of their rooms, and to the log.

In: messages of a room's session. Out: what people are told, and records of what was done.
Knows nothing of how sessions begin and end.
"""
