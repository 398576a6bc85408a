"""Logs that ROS 2 wrote: bags as MCAP or SQLite files, read without trust.

In: bytes of files. Out: the joint states in them as a table of text, for whoever reads tables.
A door to mcap and rosbags.
"""
