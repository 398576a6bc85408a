"""Rehearsals: a program of the page's editor run in private, forward and back; no arm moves.

In: a text, where it begins, and questions of one browser. Out: places, values, marks, poses.
Changes nothing of the room: the run is in a process of its own, which ends with the socket.
"""
