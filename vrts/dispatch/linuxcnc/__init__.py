"""A program and its robot as LinuxCNC takes them: G-code with O-words, INI, HAL.

In: IR, syntax trees, a scene and a run. Out: the texts of a folder, or why a line cannot be said.
Starts nothing and opens no file but its own library of subroutines.
"""
