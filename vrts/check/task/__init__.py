"""What an assignment asks for, as data, and the files that say it.

In: texts of `task.toml`, labs, staff parts, manifests. Out: a `Task`, or diagnostics.
Knows no run: whether a program does what is asked is the business of `verdicts`.
"""
