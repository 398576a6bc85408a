"""What server and session say to each other, and when a session beats.

In: lines of JSON, and time. Out: messages, frames, the next beat.
Knows no controller.
"""
