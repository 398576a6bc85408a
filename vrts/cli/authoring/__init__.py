"""Commands for authors of scenes and tasks: `new`, `scene`, `task`, `point`.

In: names, folders, places. Out: first versions of files, findings, zips.
Knows no submissions.
"""
