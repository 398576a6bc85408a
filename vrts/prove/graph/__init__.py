"""States of all futures and the legs between them: what never ends, what grows, what is excused.

In: states in the order in which a search comes to them. Out: suspects, with the decisions that lead
to them. May not know how futures go on.
"""
