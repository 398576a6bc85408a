"""Who gets in: the class code and what guesses at it cost, log-ins, entries, and whose place goes.

In: what somebody typed, from where, how many are there. Out: whether they get in, who gives way.
Knows neither sockets nor rooms.
"""
