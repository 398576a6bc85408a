"""Records that wait for room on the disk, and are written in order when there is some.

In: records. Out: whether each is on the disk.
"""
