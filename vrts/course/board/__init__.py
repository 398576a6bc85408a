"""The teacher's board: who has which mark, what holds people up, and who waits.

In: people of the lists, their attempts, who is in which room. Out: rows, causes, waits. Pure
functions: whoever asks brings the rows of the database.
"""
