"""What people said and did while a session went on, for its page.

In: voices with their times. Out: rows for lanes and the list of events.
Knows no log and no room: who may read what is decided before.
"""
