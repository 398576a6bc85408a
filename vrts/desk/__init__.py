"""The graders' desk: one page on this machine, on which graders go through a class.

In: the output of a marking. Out: records in `staff/decisions`, and files brought up to date.
Computes no mark.
"""
