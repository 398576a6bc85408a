"""What other programming languages write, one file a language or a family of them.

In: nothing. Out: tables of idioms for calls and methods that VAL-II has no word for.
"""
