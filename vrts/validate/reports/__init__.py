"""A comparison written: text, JSON, page with figures, recording of both robots.

In: a comparison. Out: what people and programs read.
Decides nothing.
"""
