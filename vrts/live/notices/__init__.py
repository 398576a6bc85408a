"""What everybody has to see: an announcement, and how many have seen it; that an arm was stopped.

In: who announced or stopped something, and whose pages show it. Out: messages.
Knows no room: who is told is for `rooms` to say.
"""
