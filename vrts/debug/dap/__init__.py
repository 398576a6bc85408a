"""The debug adapter protocol over standard input and output: a thin shell over the debugger.

In: requests of an editor. Out: responses and events.
Answers nothing itself: it asks `debug.debugger`.
"""
