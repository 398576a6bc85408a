"""Contacts and limits of motion that many futures share: certified once.

In: machines that go on. Out: what touches, and in which future. May not know why futures part.
"""
