"""The table of edits: what somebody may have meant instead, cheapest first.

In: a program as written, and what is to blame. Out: candidates. Executes nothing.
"""
