"""Functions in expressions that are not as they have to be.

In: the node of a function and its signature. Out: a diagnostic, with what to write instead.
"""
