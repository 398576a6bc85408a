"""Marks changed by hand: read from a file that marking never writes, and added to it.

In: `overrides.toml`. Out: final marks beside the computed ones.
Computes no mark.
"""
