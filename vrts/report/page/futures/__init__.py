"""Every future of a program on a page: what goes wrong, the tree of decisions, what was looked at.

In: a `Proof`, and runs in which something goes wrong. Out: sections and a whole page. Decides
nothing.
"""
