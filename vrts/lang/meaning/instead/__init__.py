"""What to write where an expression is of another kind than its place wants.

In: the node and its text. Out: help, and an edit where nothing else can be meant.
"""
