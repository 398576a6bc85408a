"""One line to one step, and what to say of a line that is none.

In: a line of a program. Out: a step of the syntax tree, or one diagnostic and a bad step.
Knows no other line.
"""
