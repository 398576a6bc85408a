"""What editors show beside the text: the mark in short, live, and the run to replay.

Takes what verifications in the background found; gives messages of our own, `vrts/...`. Knows no
run and no scene itself: both come as JSON from processes beside the server.
"""
