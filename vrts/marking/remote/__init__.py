"""Marking on other machines: shards that name nobody go out, results come back and get names."""
