"""Programs of strangers, from a folder that is not ours: how many are accepted, what damage costs.

Nothing of the folder is kept here but the hashes of its files, and what was counted.
"""
