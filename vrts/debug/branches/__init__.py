"""The tree of futures: each change made in the debugger is a branch that stays.

In: runs as they were changed, by what. Out: where to go back to, names, two of them compared.
"""
