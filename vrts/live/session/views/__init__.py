"""What is shown of a session: frames, states, news, and its deeds as a program.

In: the machine of a session. Out: messages and bytes for browsers.
Changes nothing.
"""
