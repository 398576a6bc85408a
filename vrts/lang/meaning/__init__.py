"""Names, types and structure: what the steps of a program say together.

In: steps. Out: uses and types of names, blocks and labels, initial data; diagnostics.
Writes no instruction of the IR.
"""
