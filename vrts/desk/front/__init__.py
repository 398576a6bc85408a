"""The desk over HTTP, on this machine only: who may ask, what is answered.

In: requests, which are not trusted. Out: JSON, pages and files as marking wrote them.
Decides nothing about marks.
"""
