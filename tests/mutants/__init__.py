"""Programs of students with a mistake: who makes them, and how large a mistake is.

In: the solutions of the examples. Out: `given`, which reads the mutants of `tests/data/mutants`,
and `measure`, which says how many nodes of the syntax an edit changes. Knows nobody who mends
programs.
"""
