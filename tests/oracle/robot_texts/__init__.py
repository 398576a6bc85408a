"""Second readers of what posts write, made of the makers' manuals and of nothing of vrts.

In: the text of a program in AS or V+. Out: the targets of its motions, or line and reason.
May not import vrts: what it knows of words, operators and frames stands in the manuals.
"""
