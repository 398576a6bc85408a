"""Messages between browser and server: JSON text frames on `/ws`, told apart by `type`.

In: nothing. Out: the types of messages, with the limits of their fields.
Knows neither rooms nor sockets: who may say what is decided in `rooms`.
"""
