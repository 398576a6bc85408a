"""From the download of a class to one row for each student.

In: a folder, a zip, or files. Out: who, which file, why, when, and what is wrong.
Unpacks nothing to disk, and marks nothing.
"""
