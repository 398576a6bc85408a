"""Chains of causes as lines of a terminal.

In: chains, how much a reader may be told. Out: lines. Knows no page.
"""
