"""What autograders of platforms read: one answer for one submission.

In: a result. Out: JSON of Gradescope, Classroom 50, PrairieLearn; a zip that sets one up.
Knows no class.
"""
