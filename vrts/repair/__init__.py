"""The smallest changes of a program that would earn the full mark, each of them executed.

In: a program's text, its scene, task and scenario, and its judged run. Out: repairs as data: what
to write where, what the program then earns, and how sure that is. Knows no file, no clock and no
reference solution: a count of executions says how long it may search.
"""
