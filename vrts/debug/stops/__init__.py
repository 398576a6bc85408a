"""Where a run comes to breakpoints, changes and alarms: the next one, the last one before.

In: breakpoints, watches, alarms. Out: the next of them, and what was written on the way.
Works out no condition of a passage that nobody needs.
"""
