"""From what the search found to what is told: a function of the run alone, whoever proposed.

In: touches of pairs of pieces, and intervals that may hold what is deepest. Out: events with their
times, parts, depth or distance, points and cause. Decides no verdict.
"""
