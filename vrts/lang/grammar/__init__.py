"""The grammar: Lark's tables, what drives them, and what makes nodes of their reductions.

In: tokens. Out: a syntax tree, or the place where no rule goes on. The only door to lark.
Knows no names and no types.
"""
