"""What a session did at any moment of its past, as data that a browser plays by itself.

In: a question for a stretch of the past. Out: bytes for the browser, made in a child.
Never changes the session, and never makes a frame late.
"""
