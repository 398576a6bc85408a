"""Which lines of a program a loss is to be blamed on, and how far from right things were.

In: a run and its judgement. Out: weights of lines, and residuals. Proposes nothing.
"""
