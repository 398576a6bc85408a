"""A run's timeline as arrays, and what its quantities cannot exceed between two instants.

In: polynomials of a timeline. Out: values, extremes and certified bounds over intervals.
Knows no bodies, no task and no verdict.
"""
