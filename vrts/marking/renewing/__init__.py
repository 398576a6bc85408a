"""Brings what marking wrote up to date with what is decided by hand, without marking again.

In: a marking and graders' decisions. Out: lists, feedback and pages as marking would write them.
Computes no mark: `by_hand` does.
"""
