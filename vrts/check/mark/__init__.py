"""From verdicts to a mark, with the cause of every lost point.

In: a task and the judgement of a run. Out: a `Grade` in exact arithmetic.
Asks no run anything that a verdict has not answered.
"""
