"""A text changed while it is debugged: the run goes on from before the first step that differs.

In: a run and other programs. Out: the run as they make it, with the past that both share. Writes
no file but where a value is written back to its literal.
"""
