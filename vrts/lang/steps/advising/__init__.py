"""What to say of a line that is no step, by what its writer most likely meant.

In: the line, what the parser reported of it, and a way to try out what could be meant.
Out: one diagnostic in the place of the parser's, and the structure word that the line stands for.
"""
