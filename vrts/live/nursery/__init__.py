"""One process with everything loaded that sessions need, from which they are forked.

In: the ends of pipes. Out: the process of a session, begun in milliseconds and sharing memory.
Knows neither rooms nor logs.
"""
