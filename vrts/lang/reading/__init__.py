"""Bytes to lines to tokens. Never fails: what is odd is kept and reported.

In: the bytes of a file. Out: sections, lines, tokens, and which words are keywords.
Knows no meaning of a step.
"""
