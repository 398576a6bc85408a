"""The first version of a lab file: the measures of one's own laboratory."""

LAB = """\
# A laboratory: its robot, hand and table, to be laid over any scene.
#
#   vrts scene show cans-on-bases --lab lab.toml      where things are then
#   vrts verify prog.v2 --lab lab.toml                marks there do not count, unless ...
#   lab = "lab.toml"                                  ... `[task]` of the task says so
#
# What you write here replaces what the scene says; everything else stays as it is. Remove the `#`
# where your own laboratory differs. Lengths are in mm, angles in degrees.

[lab]
title = "Our laboratory"

[lab.robot]
# name = "puma761"               # or puma560, ur5, ..: it replaces the scene's robot completely
#
# Limits of the six joints, and of straight lines at SPEED 100. These are the PUMA 761's:
# lower_deg = [-160, -200, -45, -266, -100, -300]
# upper_deg = [160, 20, 225, 266, 100, 300]
# speed_deg_s = [90, 90, 90, 180, 180, 180]
# linear_mm_s = 1000
# angular_deg_s = 100
#
# How long the arm takes to reach full speed; a rounded corner takes twice as long, or `blend_s`.
# `vrts validate --fit` finds these and the speeds out from logs of the real robot:
# acceleration_s = 0.224
#
# The TOOL when a program starts, X Y Z O A T; without it, the middle between the pads:
# tool_xyzoat = [0, 0, 150, 90, -90, 0]
#
# Where the robot stands in the coordinates of the scene. Everything in the scene's file then moves
# the other way, because programs, tasks and scenarios count from the robot's shoulder:
# at_mm = [0, 0]
# turn_deg = 0

# How the arm really stands, if its controller counts with other numbers: `vrts validate --identify`
# finds it out. `within` says how far each number may be from the truth. All keys are in the manual,
# in "What is wrong with a robot":
#   [lab.robot.built]
#   stands_off_deg = [0, 0, 0.5, 0, 0, 0]
#   [lab.robot.built.within]
#   stands_off_deg = [0, 0, 0.02, 0, 0, 0]

[lab.gripper]
# length_mm = 150                # from the flange to the middle of the pads
# opening_mm = [0, 80]           # from pad to pad: closed and open
# stroke_s = 0.3                 # from closed to open
# palm_mm = [60, 140, 80]        # behind a plate of 15 mm: along X, Y and Z of the flange
# finger_mm = [24, 20, 70]       # width, thickness and length
# pad_mm = [24, 30]              # width and length, at the tip of a finger

[lab.table]                      # the object `table` of the scene
# at_mm = [1000, 0]
# size_mm = [800, 1400]
# top_z_mm = -300                # height of its upper side, from the robot's shoulder
"""
