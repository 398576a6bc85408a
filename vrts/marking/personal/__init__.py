"""What markings keep of one student: handed out whole, and forgotten, with all others left alone.

In: markings, and who it is about. Out: a zip; or markings without them, and what still names them.
Knows no program.
"""
