"""Which programs of a class are alike, and where: for a person to look at, never a verdict.

In: programs, what their runs did, earlier years. Out: groups and pairs with evidence, pages.
Changes no mark.
"""
