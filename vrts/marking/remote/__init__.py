"""Marking on other machines.

In: a class. Out: shards that name nobody, and from their results what marking at home would write.
Trusts what comes back as little as any submission. The only door to Dask.
"""
