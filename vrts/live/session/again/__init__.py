"""A session repeated from its log, to look at it or to carry it on.

In: orders with their stamps. Out: the same run again, exactly.
Knows neither clock nor server.
"""
