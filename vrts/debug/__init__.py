"""Debugging: breakpoints, steps and alarms as questions to a run, forward and backward.

In: a program, its setting, questions. Out: instants, values, other futures.
Executes nothing step by step: a run is there before anybody looks at it.
"""
