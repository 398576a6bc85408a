"""One page about one program, complete in itself, with a replay.

In: an assessment and an audience. Out: HTML in which nothing foreign is markup.
Decides nothing, and hides nothing that the audience may read.
"""
