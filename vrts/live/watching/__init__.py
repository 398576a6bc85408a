"""How a server that is left running is started, and whether it is well.

In: what it was told, its rooms and its database. Out: a unit for systemd, numbers, words.
Knows nobody's name but in rooms, and changes nothing.
"""
