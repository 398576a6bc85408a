"""The operator's sheet: one printed page to stand beside the robot with.

In: what was planned. Out: HTML.
Decides nothing: what may be sent is known before.
"""
