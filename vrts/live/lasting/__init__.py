"""What lets a server run for a term: one clock that never jumps, and one server in a folder.

Knows neither rooms nor the database.
"""
