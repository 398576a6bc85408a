"""Locations as a table: rows exchanged, all of them in another unit, and rows that are missing.

In: a program and its scene. Out: `rows_together` and `untaught`. Single rows: `table.rows`.
"""
