"""What editors show beside the text: the mark in short, live, and the run to replay.

In: what verifications in the background found. Out: messages of our own, `vrts/...`. Knows no run
and no scene itself: both come as JSON from processes beside the server.
"""
