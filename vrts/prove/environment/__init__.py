"""What may come from outside: as data, as a file, and as states that go with a future.

In: the text of `environment.toml`, or nothing. Out: an `Environment`, and which values an input may
have now. May not know how futures are searched.
"""
