"""Results of a class in the formats of other systems.

In: rows and results of a marking, files of a teacher. Out: files, as pure functions.
Computes no mark; `write` alone touches files.
"""
