"""First versions of scenes, tasks and programs, as text with comments that say what to change."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.report.plain import one_line
from vrts.scene.block import location_block
from vrts.scene.model import Mobility, Scene

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

# Every [objects.NAME] has a kind (can, base, box or table) and a position:
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

# vrts works out a location for every can (can1_grip), every base (base1_put), and a safe place
# above everything. Others may be given here, X Y Z in mm and O A T in degrees:
#
# [locations]
# shelf = [900, 0, 130, 90, 90, 0]
"""

PROGRAM = """\
; {title}
; Check it with:  {command}
.PROGRAM main()
        SPEED 100 ALWAYS
        OPENI                           ; a run starts with a closed hand
{motion}        TYPE "Nothing is carried yet."
.END
"""

SOLUTION_HEAD = """\
; The reference solution: {title}
.PROGRAM main()
        SPEED 100 ALWAYS
        OPENI                           ; a run starts with a closed hand
        MOVE safe
"""

CARRY = """\
        MOVE safe
.END
.PROGRAM carry(start, goal)
        ; fetch the object at "start" and stand it at "goal", over the safe place
        APPRO start, 120                ; above it, quickly
        SPEED 30
        MOVES start                     ; straight down, gently
        CLOSEI                          ; stop, close, wait for the fingers
        DEPARTS 120
        MOVE safe
        APPRO goal, 120
        SPEED 20
        MOVES goal
        OPENI                           ; let go only now
        DEPARTS 120
.END
"""

TASK_HEAD = """\
# {title}
# Lengths are in millimetres, angles in degrees, times in seconds.
#
# Is it ready to be handed out?     vrts task check {folder}
# Make the files for students:      vrts task pack {folder}
# What students must not see stands in the folder `staff`.

[task]
title = {quoted}
scene = "scene.toml"

# An object counts in full when it stands upright within position_mm and orientation_deg of its
# goal, and not at all from three times that. It must be at rest, and the hand must have let go.
"""

GOAL = """
[[goal]]
object = "{body}"
on = "{base}"
position_mm = 10
orientation_deg = 5
"""

TASK_TAIL = """
# Points that the tool must pass, if you like:
#
# [[via]]
# name = "above the middle"
# at_mm = [900, 0, 100]
# radius_mm = 20

# Up to 1.25 times the duration of the reference, `staff/solution.v2`, a program gets the time bonus
# in full; it falls to nothing at twice that.

[time]
reference_s = {reference}

# The mark: round(max(0, targets + vias - contacts) + time bonus). These are the usual numbers.

[mark]
targets = 6.0                # goals; without via points those of the vias are added
vias = 2.5                   # via points
first_contact = 1.5          # lost by the first contact
further_contact = 1.0        # lost by each further contact, and by each object that is dropped
contact_cap = 5.0            # no more is lost by contacts and drops
time_bonus = 1.5             # only for a program without any fault
"""

STAFF_TASK = """\
# What is checked at marking only. Students are told how many such checks there are, no more.
# The reference must pass them too. Take the `#` away to hide a via point:
#
# [[via]]
# name = "high above the middle"
# at_mm = [900, 0, 150]
# radius_mm = 400
"""

README = """\
# {title}

Write a VAL-II program that does this:

{goals}

Begin with `start.v2`. Save your program as `mine.v2` and mark it with

    vrts grade {name}-student.zip mine.v2

You get the time bonus when you need no longer than {par} s and touch nothing.
"""


class Carrying(NamedTuple):
    """An object to carry, and where from and to."""

    body: str
    base: str
    start: str  # name of a location
    goal: str


def new_scene(name: str, title: str) -> str:
    """Return a scene with a can and a base."""
    return SCENE.replace("TITLE", title).replace("NAME", name)


def new_program(command: str, scene: Scene) -> str:
    """Return a program that moves to the safe place and holds all locations of a scene.

    Args:
        command: What to type to have the program checked.
        scene: The workspace.
    """
    motion = "        MOVE safe\n" if "safe" in scene.locations else ""
    text = PROGRAM.format(title=one_line(scene.title), command=command, motion=motion)
    return text + _locations(scene.locations)


def carryings(scene: Scene) -> tuple[Carrying, ...]:
    """Return an object for every base, as far as both can be reached."""
    movable = [body for body in scene.bodies if body.mobility is Mobility.MOVABLE]
    bases = [body for body in scene.bodies if body.kind == "base"]
    found: list[Carrying] = []
    for base in bases:
        for number, body in enumerate(movable, 1):
            start = f"{body.name}_grip".lower()
            goals = (f"{base.name}_put".lower(), f"{base.name}_put{number}".lower())
            goal = next((name for name in goals if name in scene.locations), None)
            taken = any(body.name == other.body for other in found)
            if start in scene.locations and goal is not None and not taken:
                found.append(Carrying(body.name, base.name, start, goal))
                break
    return tuple(found)


def new_solution(title: str, scene: Scene, work: Sequence[Carrying]) -> str:
    """Return a program that carries everything to its base."""
    calls = "".join(f"        CALL carry({one.start}, {one.goal})\n" for one in work)
    return SOLUTION_HEAD.format(title=one_line(title)) + calls + CARRY + _locations(scene.locations)


def new_task(title: str, folder: str, work: Sequence[Carrying], reference_s: Fraction) -> str:
    """Return a task that asks for what `new_solution` does."""
    goals = "".join(GOAL.format(body=one.body, base=one.base) for one in work)
    head = TASK_HEAD.format(title=one_line(title), quoted=_quoted(title), folder=folder)
    return head + goals + TASK_TAIL.format(reference=f"{float(reference_s):g}")


def new_readme(title: str, name: str, work: Sequence[Carrying], par_s: Fraction) -> str:
    """Return the page for students."""
    goals = "\n".join(f"- stand `{one.body}` on `{one.base}`" for one in work)
    return README.format(title=one_line(title), name=name, goals=goals, par=f"{float(par_s):.1f}")


def _quoted(text: str) -> str:
    """Return a text as a TOML string."""
    escaped = one_line(text).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def _locations(locations: Mapping[str, Pose]) -> str:
    return location_block(locations) if locations else ""
