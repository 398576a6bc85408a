"""How far every goal and relation of a task was met.

In: a run and a task. Out: a `Reached` for each, with exact errors and a share from 0 to 1.
Knows no points and no reports: what is said of it is the business of `verdicts`.
"""
