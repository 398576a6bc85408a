"""How platforms name what they let teachers download, one file for each platform.

In: names of files. Out: whose each is, and when it came.
Looks into no file.
"""
