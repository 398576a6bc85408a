"""What the server keeps: one SQLite file, written by one thread.

In: what happened. Out: the same after a crash. The only door to sqlite3.
Knows neither sockets nor sessions.
"""
