"""What becomes of a room whose session has died or cannot begin, and what its people are told.

In: how a session ended, and what the log says. Out: whether it goes on, and words for the choice.
Knows neither processes nor the database.
"""
