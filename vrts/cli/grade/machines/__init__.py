"""`vrts grade plan`, `run`, `merge`: a class marked in shards, on other machines.

In: a task, a class, shards. Out: a plan, results of shards, and all of them together.
Knows no format of a file: that is in `marking/remote`.
"""
