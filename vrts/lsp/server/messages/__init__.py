"""Messages of an editor, read and checked before anything is done with them.

In: bytes from standard input. Out: calls of what answers, or an error that says what is wrong.
Knows nothing of programs.
"""
