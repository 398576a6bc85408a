"""Which ways lead through a program: loops, branches and calls that hardly do what is meant.

In: resolved programs and their structures, and their IR. Out: warnings.
Runs nothing: a way that a condition with variables may take is a way.
"""
