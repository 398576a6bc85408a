"""Syntax trees: what one line says, before anybody asks what its names mean.

In: nothing; others build the nodes. Out: tokens, expressions, statements, steps and programs.
Knows nobody: every node is plain data with the offsets of its text.
"""
