"""One candidate compiled, executed and marked, no further than it takes to say no.

In: a text. Out: how far it came, and its mark where it is good. Proposes nothing.
"""
