"""The steps of a run backward: what was executed, what it read, who wrote that, who called it.

In: a run. Out: executed steps, readings, links of values. Chains of causes and what mends programs
both look here. Knows no effect: nothing of contacts, grips or marks.
"""
