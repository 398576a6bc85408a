"""Steps that are none, of which the nearest right step is another than the one that is meant.

In: the text of a line that is no step. Out: what is meant, and where it is clear, what to write.
These come before all idioms and all signs.
"""
