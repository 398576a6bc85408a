"""Does the robot, or what it carries or drops, hit anything? Certified for every instant.

In: a run and its scene. Out: contact events, near misses, clearance over time, and their words.
Knows no task and no mark.
"""
