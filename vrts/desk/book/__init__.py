"""The folder of a marking, as it is at this moment: read, watched, and added to.

In: files of a marking and of graders. Out: one unchanging value for each state of them.
Knows nothing of HTTP.
"""
