"""A log of a real robot, whatever wrote it.

In: the text of a table. Out: samples of joints and tool with their times, in SI.
Fits nothing.
"""
