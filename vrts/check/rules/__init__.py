"""What costs how many points, and what programs may set: the numbers of a task and their files.

In: tables of a task file. Out: `MarkScheme`, `Locks`.
Knows no goals, no runs.
"""
