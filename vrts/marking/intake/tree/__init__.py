"""A download as files by name, wherever their bytes are, read without trust.

In: a folder, a zip, a list. Out: names, bytes, and what kind of content they are.
Knows no students.
"""
