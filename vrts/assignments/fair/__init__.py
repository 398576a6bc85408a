"""Whether variants of a task are fair: each can be done, all are as hard, and copies earn little.

In: a task with `[variants]`, and who gets which. Out: what was tried, and every variant that falls
out, by name. It decides by runs of the reference, which are certified like those of students.
"""
