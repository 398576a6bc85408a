"""The state of a machine apart from the time: two that are alike go on alike.

In: a machine between two ticks, or within one. Out: plain values to compare. Loops that repeat
themselves are found by it, and futures that meet. May not know who asks.
"""
