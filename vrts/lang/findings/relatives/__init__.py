"""Operands of V+ and AS that are of another kind, or in another order, than their step takes.

In: resolved programs. Out: diagnostics. Asks of each step no more than what its word is.
"""
