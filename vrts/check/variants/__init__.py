"""Variants of a task: what may be another for each student, which one is drawn, and its files.

In: the section `[variants]` of a task, and the texts of its files. Out: a finite set of variants,
the one that a key gives to a student, and the same files with the values of that variant.
Knows nothing of classes, and opens no file.
"""
