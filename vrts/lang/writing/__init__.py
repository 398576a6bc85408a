"""Programs as text: the canonical layout, and what STORE writes.

In: lines, steps, or a compilation. Out: text.
Changes no meaning.
"""
