"""`vrts dispatch` and its subcommands: from a verified program to a controller and back.

In: programs, bundles, a serial port. Out: bundles, sheets, transcripts.
Can send nothing by itself: what may be sent is in `dispatch.allowed`.
"""
