"""Programs run without a task, and the files of their runs: read here, and made into bytes.

In: a request, or the bytes of a `.vrun` file. Out: a run with what a file of it tells, or bytes.
What is wrong in a saved run is a diagnostic, raised as `Refused`. Knows no task and no mark.
"""
