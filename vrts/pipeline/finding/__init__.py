"""Which task a program belongs to, where nobody says.

In: the path of a program. Out: a task file, or None. Reads folders, and knows no setting.
"""
