"""Every word of the language: what it is, who knows it, how short it may be.

In: nothing. Out: one table, which everything else that knows words is made of.
Knows no syntax.
"""
