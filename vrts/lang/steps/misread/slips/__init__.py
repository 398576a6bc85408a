"""Steps with a slip of the pen: a sign twice, letters for digits, digits before letters.

In: the text of a line that is no step. Out: what is meant, and where it is clear, what to write.
"""
