"""A program verified as a controller will hold it.

In: a program, scenarios, a profile. Out: a bundle with the operator's sheet, or refusals.
Talks to no controller.
"""
