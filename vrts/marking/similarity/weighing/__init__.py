"""How much what programs share speaks for one source: rarity, chance, groups. Numbers alone.

In: programs as sets of digests. Out: for each pair how seldom innocent programs are so much alike,
and the groups that hang together.
"""
