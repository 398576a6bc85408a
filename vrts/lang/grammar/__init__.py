"""The grammar: Lark's tables, what drives them, and the nodes that they build.

In: tokens. Out: a syntax tree, or the place where no rule goes on. The only door to lark.
Knows no names and no types.
"""
