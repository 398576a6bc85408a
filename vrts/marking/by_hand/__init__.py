"""Marks changed by hand: read from files that marking never writes, and added to them.

In: `overrides.toml` and graders' files. Out: rows with what is decided, beside what was computed.
Judges no program.
"""
