"""Instructions of the IR as closures, one file for each kind.

In: instructions of the IR. Out: closures that change plain state and say what comes next.
Knows no other program than the one at work.
"""
