"""Steps in which a piece is written as another language has it, or that are no steps but prose.

In: the text of a line that is no step. Out: what is meant, and what to write.
"""
