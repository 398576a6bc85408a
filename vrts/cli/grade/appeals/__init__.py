"""`vrts grade evidence`, `reproduce`: what a mark rests on, packed and marked again.

In: a marking, or an evidence zip. Out: the zip, or what comes of it.
Knows no format of a file: that is in `marking/appeals`.
"""
