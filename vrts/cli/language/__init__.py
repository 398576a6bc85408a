"""Commands that need no robot: `compile`, `fmt`, `explain`, `support`.

In: program files, words, codes. Out: diagnostics, text.
Loads no heavy library, so that each of them feels instant.
"""
