"""`vrts validate` and its subcommands: a real robot beside its simulation.

In: a program, a log or frames of a camera. Out: errors as text, page and recording.
Needs the extra `validate`.
"""
