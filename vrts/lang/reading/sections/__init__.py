"""Lines and sections of a file: what begins and ends them, and lines that stand astray.

In: a line without its comment. Out: what section it begins or ends, or a diagnostic.
"""
