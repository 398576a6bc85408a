"""Programs verified in the background, and what their runs have against them.

In: texts and their setting. Out: findings, times and speeds, tied to lines.
Works in processes beside the server, which never waits.
"""
