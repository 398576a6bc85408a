"""Steps with a slip: signs, brackets, words, names and labels written a little otherwise.

In: the text of a line that is no step. Out: what is meant, and where it is clear, what to write.
"""
