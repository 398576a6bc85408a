"""Names of people: any script, nobody else's, and none that passes for a role.

In: names that people give themselves, tables of Unicode. Out: names that can be shown.
Knows no server: what is kept of people is in `store`.
"""
