"""What programmers write who come from other languages, and what VAL-II has for it.

In: the text of a step that is none. Out: what it is, and what to write instead. The tables are
data; a step written instead is given out only if it is one.
"""
