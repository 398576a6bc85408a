"""Hand-ins of a course: kept as marking takes them, judged by the clock, marked by public checks.

In: programs of students, the tasks' rules. Out: files below `handed-in`, rows of the database,
public marks. Knows no page, and no hidden check leaves the process that marks.
"""
