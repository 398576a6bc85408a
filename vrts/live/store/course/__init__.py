"""What the server keeps of a course: people of its lists, hand-ins, rooms of their own.

In and out: rows of the one database. What a course may do is decided above.
"""
