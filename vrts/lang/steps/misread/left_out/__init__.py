"""Steps in which a sign was left out: quotes, a blank or `*`.

In: the text of a line that is no step. Out: what is meant, and where it is clear, what to write.
"""
