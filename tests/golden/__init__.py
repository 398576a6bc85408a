"""Whole outputs kept as files: a person reads the difference before it is committed."""
