"""The controller's machine: two programs and an arm, tick by tick.

In: plain state and commands. Out: the same state, later.
Does not know how a run is asked: that is in `run` and `state`.
"""
