"""What the server and the processes beside it say to each other, as lines of JSON.

In: texts to verify. Out: findings and times, tied to places of those texts.
Knows no run: whoever imports it starts as fast as before.
"""
