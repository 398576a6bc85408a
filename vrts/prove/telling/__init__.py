"""From what a search suspects to what is told: replayed, shrunk, judged by a task, in sentences.

In: a search that is over. Out: what goes wrong with its scenario, and over what a proof speaks. May
not know how futures were searched.
"""
