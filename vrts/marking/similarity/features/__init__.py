"""What of a program is compared with others: motion, manner, steps, numbers, words, in pieces.

In: a program and the sketch of its run. Out: features, each with the line it comes from. Knows
nothing of other programs.
"""
