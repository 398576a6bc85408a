"""One session: a controller whose run grows with the clock, in a process of its own.

In: orders with their stamps. Out: pose frames and news.
Knows neither people nor network.
"""
