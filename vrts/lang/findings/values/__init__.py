"""Numbers known before a run: what a controller surely refuses, and what is surely not meant.

In: resolved programs, and their IR for the ways through them. Out: warnings.
Runs nothing: what a number may be is an interval, and what is not known is not spoken of.
"""
