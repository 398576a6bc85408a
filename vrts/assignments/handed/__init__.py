"""What students are told of a task in its README.md: written from the task, and compared with it.

In: the public part of a task, its scene, the text of its README. Out: texts and findings.
Knows nothing of what is hidden, but whether anything is: then the page says that more is checked.
"""
