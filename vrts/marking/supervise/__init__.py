"""One process for each submission, with limits, so that none can cost the others their marks.

In: jobs and limits. Out: an outcome for each, whatever it did.
Knows nothing of programs or marks.
"""
