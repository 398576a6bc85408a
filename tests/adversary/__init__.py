"""Does any case make the collision check miss a contact, or tell of one that is not there?

Cases at and beside the thresholds, proposers that lie, and a judge that shares no code with the
check. `python -m tests.adversary 0 200` prints the figures of a shard.
"""
