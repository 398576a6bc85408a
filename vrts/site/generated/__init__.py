"""Pages of the manual made of what vrts knows: nothing is typed twice, so nothing drifts.

In: vocabulary, spec cases, pages of codes, schemas, commands, docstrings. Out: Markdown (MyST).
"""
