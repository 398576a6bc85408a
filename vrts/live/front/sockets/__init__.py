"""WebSockets of the page: a room's, the editor's help, rehearsals.

In and out: messages of one browser. Decides who may connect; what they may ask is decided below.
"""
