"""Tables of all events and calls of a run, and the small language that asks them.

In: a run, a question as text. Out: rows with their values, and where each leads. Knows no client.
"""
