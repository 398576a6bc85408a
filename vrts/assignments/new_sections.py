"""Sections of a task that nobody needs, as comments: what else may be asked for.

The numbers are such that the reference solution of a new task keeps to all of them.
"""

from vrts.base.pose import Vector
from vrts.base.units import mm

SECTIONS = """
# What else a task may ask for. Remove the `#`, and change the numbers.
#
# A point that the tool must pass within radius_mm. You may leave out the last three lines: where
# the tool has to point there, how far it may be off, and how fast it may be there (from, to):
#
# [[via]]
# name = "over the middle"
# at_mm = [{x}, {y}, {z}]
# radius_mm = 30
# approach = [0, 0, -1]
# cone_deg = 10
# speed_mm_s = [0, 1500]
#
# How an object is to end beside another one, on it, or in a box: one of left_of, right_of,
# farther_than and nearer_than (with by_mm), stacked_on, aligned_with (along "x" or "y"), or from_mm
# and to_mm. Relations share the points of goals, by their weights:
#
# [[relation]]
# object = "{body}"
# stacked_on = '{base}'
# weight = 0.5
#
# A box that the tool stays out of; with keeps_out = "robot" arm, hand and what it holds, too.
# Here and below, `points` are lost when a program does not keep to it:
#
# [[zone]]
# name = "beside the table"
# from_mm = [{x}, 1500, -1000]
# to_mm = [{end}, 2000, 1000]
# keeps_out = "robot"
# points = 1
#
# An object that must not be tilted while it is carried:
#
# [[upright]]
# object = "{body}"
# within_deg = 5
# points = 1
#
# A limit: one of joint_percent (of the joints' own limits), tool_mm_s, or a distance to what the
# wrist, the elbow or the shoulder cannot do: wrist_deg, elbow_deg, shoulder_mm:
#
# [[limit]]
# tool_mm_s = 2500
# points = 0.5
#
# A rule for the program: one of must_use, must_not_use and most_steps:
#
# [[rule]]
# must_use = "MOVES"
# points = 0.5
#
# That nothing goes wrong, whatever comes from outside, and whenever. `environment` names a file
# that says what may come (`vrts new environment` writes it); without one everything is free. What
# is hidden counts at marking only: then put the file into `staff`:
#
# [prove]
# hidden = false
# states = 20000
# points = 3
#
# Nearer than this is reported as a near miss, which costs nothing (5 mm unless you say otherwise):
#
# [collision]
# near_miss_mm = 5
#
# When hand-ins are due, and how many points being late costs, by the platform's times: `per_day`
# for each day begun, at most `most`, and none within grace_min. What comes after `closed` gets 0.
# For prices that are not by the day, use [[late.step]] with after_h and points:
#
# [late]
# due = 2030-11-30T23:59:00+01:00
# grace_min = 10
# per_day = 1
# most = 5
# closed = 2030-12-07T23:59:00+01:00
#
# Which of several hand-ins of a student counts: the latest, or the one with the best mark:
#
# [submissions]
# keep = "latest"
"""


def new_sections(body: str, base: str, middle: Vector) -> str:
    """Return the comments.

    Args:
        body: Name of an object that is carried.
        base: What it ends on.
        middle: A point that the reference passes, in W [m].
    """
    x, y, z = (round(mm(value)) for value in middle)
    return SECTIONS.format(body=body, base=base, x=x, y=y, z=z, end=x + 500)
