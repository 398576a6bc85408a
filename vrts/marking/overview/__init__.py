"""A class on one page, for those who mark.

In: the rows of a class. Out: HTML.
Computes no mark, and asks no run.
"""
