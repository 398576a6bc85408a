"""`vrts grade` and its subcommands: marking a class, and all that follows from marks.

In: a task and a download. Out: what `marking` writes, and a line for each submission.
Knows no format of a file: that is in `marking`.
"""
