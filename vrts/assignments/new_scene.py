"""The first version of a scene, with comments that say what to change."""

SCENE = """\
# TITLE: a table, a base and a can, in front of a PUMA 761.
#
# Lengths are in millimetres, angles in degrees. The origin is the robot's shoulder: X points
# forward, Y to the left, Z up. The floor is 1120 mm below it.
#
# Look at it while you change it:  vrts scene watch NAME --svg map.svg
# Look for mistakes:               vrts scene check NAME

title = "TITLE"

[robot]
name = "puma761"               # or puma560, puma762, ur5, ...

# Every [objects.NAME] has a position and a kind: table, can, base, box, dish, stand, oven or pizza.
#   at_mm = [x, y] and on = "..."   the middle of its underside, and what it stands on; or
#   at_mm = [x, y, z]               the middle of its underside.
# turn_deg turns it about the vertical; color is a name such as "red", or "#rrggbb".

[objects.table]
kind = "table"
at_mm = [1000, 0]
size_mm = [800, 1400]          # along X and Y
top_z_mm = -300                # height of its upper side

[objects.base1]
kind = "base"                  # bases stay where they are
at_mm = [950, 300]
on = "table"
size_mm = [120, 120, 100]      # along X, Y and Z; or radius_mm and height_mm

[objects.can1]
kind = "can"                   # cans can be carried; the hand opens 80 mm
title = "the red can"
at_mm = [850, -300]
on = "table"
radius_mm = 30
height_mm = 115

# Remove the `#` for a box, a dish, and a tilted stand to set the dish on:
#
# [objects.box1]
# kind = "box"                 # fixed, unless you write fixed = false
# at_mm = [1250, 0]
# on = "table"
# size_mm = [100, 100, 80]
#
# [objects.dish]
# kind = "dish"                # gripped by its wall: give the place for that below
# at_mm = [850, -550]
# on = "table"
# radius_mm = 110              # of the rim
# height_mm = 45
#
# [objects.stand]
# kind = "stand"               # a plate on two boards, lower toward the robot
# at_mm = [980, 550]
# on = "table"
# size_mm = [280, 280]         # of the plate: along its slope, and across
# height_mm = 120              # of the middle of the plate above the table
# slope_deg = 20
#
# [objects.bracket]
# kind = "mesh"                # a part from CAD: see the manual, "Put a part from CAD into a scene"
# file = "bracket.stl"         # in this folder; then: vrts scene check NAME --write
# unit = "mm"
# at_mm = [850, 550]
# on = "table"

# vrts works out a location for every can (can1_grip), every base (base1_put), and a safe place
# above everything. You may give others here, X Y Z in mm and O A T in degrees:
#
# [locations]
# shelf = [900, 0, 130, 90, 90, 0]
# dish_grip = [850, -447, -268, 90, 90, 0]
"""


def new_scene(name: str, title: str) -> str:
    """Return a scene with a can and a base."""
    return SCENE.replace("TITLE", title).replace("NAME", name)
