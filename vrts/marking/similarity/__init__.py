"""Which programs of a class are alike, and where: for a person to look at, never a verdict.

In: texts of programs. Out: pairs with the lines they share, a page.
Changes no mark.
"""
