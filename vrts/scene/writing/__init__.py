"""Scenarios as files: what is read back is what was written.

In: a scenario. Out: the text of its file. May not know who made the scenario, nor where it goes.
"""
