"""One question to a run each: limits, targets, via points, time, zones, demands.

In: a run, its scene, a task. Out: verdicts with evidence, three-valued.
Knows no points: what a verdict costs is the business of `mark`.
"""
