"""Contacts and the public mark of a session, found beside it.

In: a run that grows. Out: contacts, near misses, the mark of now.
Delays no beat: it works in a process of its own.
"""
