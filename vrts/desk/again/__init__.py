"""Marks some or all of a class again, in a process beside the desk.

In: what the marking was. Out: the same files, made anew; progress.
Knows nothing of HTTP.
"""
