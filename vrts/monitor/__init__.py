"""The monitor: the operator's dialogue over a controller.

In: lines, keys, time. Out: text as VAL-II writes it, commands for the controller.
Reads no terminal and no clock, but in `screens`.
"""
