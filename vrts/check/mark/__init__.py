"""From verdicts to a mark, with the cause of every lost point.

In: a task, a run and its judgement. Out: a `Grade` in exact arithmetic.
Judges nothing anew: a run only tells where a loss comes from.
"""
