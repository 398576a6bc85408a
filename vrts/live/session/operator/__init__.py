"""What an operator does: held keys, motions by pointer, RECORD, lines of the monitor.

In: orders. Out: commands for the controller, or why not.
Knows nothing of what is shown.
"""
