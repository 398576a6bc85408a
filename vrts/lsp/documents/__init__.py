"""Program files as an editor holds them, and the names in them.

In: buffers and the files beside them. Out: names, their uses, what belongs together.
Answers no question of an editor.
"""
