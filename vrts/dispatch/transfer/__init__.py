"""Conversation with a controller: what is sent, read back, fetched and compared.

In: a bundle and a line. Out: what stands in the controller, and a transcript.
Sends nothing that `dispatch.allowed` does not list. The only door to pyserial.
"""
