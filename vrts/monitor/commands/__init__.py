"""Commands of the monitor, one file for each group of the manual.

In: a command and the desk. Out: text, questions, commands for the controller.
Knows no terminal.
"""
