"""Work that goes on beside the answers: folders read, files watched, programs run.

In: what a client has open. Out: what is new about it, told to the session.
Runs and arms are known to processes of their own, never to the server.
"""
