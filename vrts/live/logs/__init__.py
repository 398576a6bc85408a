"""Sessions as their logs hold them: read, verified, repeated, marked, shown again.

In: logs of the database or of a file. Out: sessions to repeat, rows of marks, pages.
Talks to no browser.
"""
