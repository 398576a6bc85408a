"""Proposals by python-fcl, which ends the process it runs in now and then: so it has its own.

In: pairs of placed shapes. Out: proposals, and none where the child died of the question.
What marks never loads fcl, and asks the child for nothing that a mark rests on.
"""
