"""Straight lines: how the tool goes, what that asks of the joints, and what stops it on the way.

In: two poses of the tool, times, an arm. Out: set points joined by cubics, or what is in the way.
Knows no program and no settings of motions.
"""
