"""What is wrong with a real robot, named: a model of it fitted to a log, cause by cause.

In: a run and a log. Out: the fewest causes that explain the log, their intervals, what is left.
Executes the program again with other numbers; knows nothing of files or of how it is told.
"""
