"""The PUMA arms and their gripper as data: every number with its source, or the word assumed.

In: nothing. Out: robots.
Computes nothing.
"""
