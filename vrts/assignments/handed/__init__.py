"""What students are told of a task in its README.md: written from the task, and compared with it.

In: the public part of a task, the text of its README. Out: texts and findings, as pure functions.
Knows nothing of what is hidden but how many checks there are.
"""
