"""Syntax trees without faults to the flat IR.

In: resolved steps. Out: instructions and expressions of the IR, with their spans.
Finds nothing wrong: that was done before.
"""
