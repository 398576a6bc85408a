"""What lets a server run for a term: one clock that never jumps, and one server in a folder.

In: the machine's clocks, a folder. Out: times, and a lock or a sentence why there is none.
Knows neither rooms nor the database.
"""
