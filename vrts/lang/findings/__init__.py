"""Programs that are right and yet surely not meant: unused, unreachable, endless, slow.

In: resolved programs. Out: warnings.
Changes nothing: a program without any of this compiles to the same IR.
"""
