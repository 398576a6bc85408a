"""A class of submissions, each to a result row, whatever it contains.

In: a task and what was handed in. Out: results, rows, marks, reports, in one folder.
Trusts no submission, and lets none cost another its mark.
"""
