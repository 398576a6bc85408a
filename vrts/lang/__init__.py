"""VAL-II text to IR, and back to text.

In: the bytes of program files, a dialect. Out: an `ir.Module`, diagnostics, canonical text.
Knows no robot, no scene and no run.
"""
