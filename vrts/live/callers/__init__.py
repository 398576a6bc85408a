"""Who calls and says nothing, says it without end, or far too fast: such connections are ended.

In: connections of HTTP and WebSockets, before anything of vrts reads them. Out: those that go on.
Knows no room and no account.
"""
