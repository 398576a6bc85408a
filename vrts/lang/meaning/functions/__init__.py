"""Functions in expressions: their arguments, and those that are not as they have to be.

In: the node of a function and its signature. Out: its type, or a diagnostic with what to write.
"""
