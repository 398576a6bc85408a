"""A run that grows in place, and what it forgets into a file.

In: commands and time. Out: the machine now, and any moment before.
Knows no messages.
"""
