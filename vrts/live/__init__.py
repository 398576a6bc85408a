"""Shared sessions in the browser: the server, and a process for each session.

In: scenes and tasks, messages of browsers. Out: frames, messages, a log of everything.
What an operator may not do is refused here, whatever a page shows.
"""
