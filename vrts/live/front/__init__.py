"""The door of the server: addresses, pages, WebSockets, and what guards them.

In: requests from the network, none of which is trusted. Out: files, answers, messages.
Knows no robot: what is asked of one goes to `rooms`.
"""
