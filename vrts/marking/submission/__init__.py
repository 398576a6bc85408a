"""One submission: marked in a process of its own, and its result.

In: bytes of a program, a setting. Out: a result, and files about it.
Knows no other submission and no name.
"""
