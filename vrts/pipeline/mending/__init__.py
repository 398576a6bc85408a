"""Programs that do the wrong thing, and what would mend them: the search with its setting.

In: a request about a program. Out: repairs, or why nothing is looked for. Writes no file.
"""
