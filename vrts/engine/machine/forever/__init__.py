"""Programs that never end: states that come again, and who waits for whom.

In: a machine after a tick. Out: a diagnostic that ends the robot program, or nothing.
Never says "never" of what may happen; may be silent about what does not.
"""
