"""Tasks of a course that are another one for each student: given once, sealed, nobody else's.

In: a person of the lists, with the team. Out: the folder of their own task, as any other task's.
"""
