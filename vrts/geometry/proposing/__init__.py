"""Who says where two shapes may be nearest: coal, python-fcl, or nobody.

In: pairs of placed shapes. Out: a direction and two points for each, which nobody vouches for.
Decides nothing: `proving` does, by the shapes alone. Starts no process.
"""
