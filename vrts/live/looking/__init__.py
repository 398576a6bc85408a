"""What was asked of the past of a room's session: kept, so that many who look ask once.

In: numbers of blocks, and what sessions answer. Out: bytes for browsers.
Knows no room and no person.
"""
