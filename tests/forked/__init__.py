"""Tests divided among workers that are forked once all tests are read: `pytest --forked=N`.

A plugin of pytest. To read 16,000 tests takes half a minute of processor, which each worker of
xdist takes anew, and all that it loads takes memory. A forked worker has everything already, in
memory that it shares with the others.
"""
