"""The way to a pose, asked about before anybody goes it: does it touch anything, what and where?

In: where the arm stands, where it is to go, and how. Out: what would touch, certified by the same
check as every run, and the path of the tool. Frames never wait for it.
"""
