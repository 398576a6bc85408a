"""What a mark rests on, marking again, and who moves when a task is repaired.

In: results and the files behind them. Out: evidence in a zip, differences.
Changes no mark.
"""
