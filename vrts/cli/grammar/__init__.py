"""How commands are spoken: one name for one thing, groups, near misses, old names, how all end.

In: commands as each file declares them. Out: the same with what every command has, and an exit
status whatever happens. Knows no single command.
"""
