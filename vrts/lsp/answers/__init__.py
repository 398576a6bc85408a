"""One question of an editor each: completion, hover, symbols, renaming, mending.

In: documents and a place. Out: plain values.
Executes no program.
"""
