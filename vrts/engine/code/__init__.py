"""The IR made ready to run: instructions and expressions as closures over plain state.

In: a module of the IR. Out: programs as lists of closures, and the layout of their memory.
Does not know when they are called: ticks are the business of `machine`.
"""
