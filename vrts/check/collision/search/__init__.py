"""The certified search: intervals of time halved until every one is free or a contact.

In: rows of pairs. Out: what was found of each row, with the times between which it holds.
Does not know what a contact means, nor who is to blame.
"""
