"""Sessions that fall asleep with all they are in a file, and wake as they were.

In: a session at rest. Out: bytes, and from these the same session again in another process.
Knows no room; the log stays the truth, so a state that does not fit is left aside.
"""
