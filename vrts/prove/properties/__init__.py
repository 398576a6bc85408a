"""Properties of one's own, [[never]] and [[always]]: watched tick by tick.

In: properties of an environment, and moments of a machine or of a run. Out: which property is
broken, and when. May not know how futures are searched.
"""
