"""Post-processors: one module for each language that a program can be written in anew.

In: syntax trees of a program. Out: its text in another dialect, with the same motion.
Talks to no controller.
"""
