"""Structure words and their partners: which belong together, and what is said where one is missing.

In: the steps of a program. Out: its blocks, and one diagnostic for each word without a partner.
"""
