"""First versions of tasks and programs, as text with comments that say what to change."""

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.assignments.handed.readme import written
from vrts.assignments.handed.task_words import task_words
from vrts.assignments.new_sections import new_sections
from vrts.base.pose import Pose, Vector
from vrts.base.units import mm
from vrts.check.task.task import Task
from vrts.report.plain import one_line
from vrts.scene.block import location_block
from vrts.scene.model import Scene

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
# lab = "lab.toml"             # your own arm, hand and table: see `vrts new lab`

# An object counts in full when it stands upright within position_mm and orientation_deg of its
# goal, and not at all from three times that. It must be at rest, and the hand must have let go.
# Turns that nobody can see, such as half a turn of a brick, do not count: `symmetry = "none"`
# changes that. Where `object` and `on` are lists, such as ["can1", "can2"], every object needs a
# place of its own. With `lifted = 0.2` an object that is lifted, but not in place, keeps that share
# of its points.
"""

GOAL = """
[[goal]]
object = "{body}"
on = "{base}"
{turn}position_mm = 10
orientation_deg = 5
"""

TASK_TAIL = """
# Up to 1.25 times the duration of the reference, `staff/solution.v2`, a program gets the time bonus
# in full; it falls to nothing at twice that.

[time]
reference_s = {reference}

# What programs may set: parameters, switches, and how fast they may accelerate. Without this
# section: every switch, and every parameter except those of the installed robot (SPEED.MAX and the
# like).
#
# [settings]
# parameters = ["HAND.TIME"]
# switches = ["CP", "MESSAGES"]
# acceleration_percent = 100

# The mark: round(max(0, targets + vias - contacts - broken limits - demands) + time bonus). These
# are the usual numbers. With `total = 20` it is out of 20, and the numbers that you leave out are
# twice as large. With `contacts_by = "time"` contacts cost by how long they last, not by how many
# there are: `per_second` points each second. With `contacts_by = "depth"`: `per_mm` points each mm.

[mark]
targets = 6.0                # goals; without via points, their points are added here
vias = 2.5                   # via points
first_contact = 1.5          # lost by the first contact
further_contact = 1.0        # lost by each further contact, and by each object that is dropped
contact_cap = 5.0            # the most that is lost by contacts and drops
time_bonus = 1.5             # only for a program without any fault
broken_limit = 1.5           # lost once, by breaking a limit of the robot or moving one
"""

STAFF_TASK = """\
# What is checked at marking only. Students are told how many such checks there are, no more.
# The reference must pass them too. Whatever `task.toml` may ask for can be hidden here, except the
# sections [task], [time], [mark], [late], [submissions] and [settings]. Take the `#` away to hide a
# via point:
#
# [[via]]
# name = "high above the middle"
# at_mm = [{x}, {y}, {z}]
# radius_mm = 60
#
# Programs are also marked in every scene of the folder `staff/scenes`, and the lowest mark counts:
# copy `scene.toml` there under another name, and move something.
"""

README = """\
# {title}

Write a VAL-II program that does what stands below. Begin with `start.v2`. Save your program as
`mine.v2` and mark it with

    vrts grade {name}-student.zip mine.v2
"""


class Carrying(NamedTuple):
    """An object to carry, and where from and to."""

    body: str
    base: str
    start: str  # name of a location
    goal: str
    turn: float = 0.0  # of the goal [degrees]


def new_program(command: str, scene: Scene) -> str:
    """Return a program that moves to the safe place and holds all locations of a scene.

    Args:
        command: What to type to have the program checked.
        scene: The workspace.
    """
    motion = "        MOVE safe\n" if "safe" in scene.locations else ""
    text = PROGRAM.format(title=one_line(scene.title), command=command, motion=motion)
    return text + _locations(scene.locations)


def new_solution(title: str, scene: Scene, work: Sequence[Carrying]) -> str:
    """Return a program that carries everything to its base."""
    calls = "".join(f"        CALL carry({one.start}, {one.goal})\n" for one in work)
    return SOLUTION_HEAD.format(title=one_line(title)) + calls + CARRY + _locations(scene.locations)


def new_task(
    title: str, folder: str, scene: Scene, work: Sequence[Carrying], reference_s: Fraction
) -> str:
    """Return a task that asks for what `new_solution` does, with comments on what else it may."""
    goals = "".join(map(_goal, work))
    head = TASK_HEAD.format(title=one_line(title), quoted=quoted(title), folder=folder)
    middle = above_middle(scene)
    tail = TASK_TAIL.format(reference=f"{float(reference_s):g}")
    return head + goals + new_sections(work[0].body, work[0].base, middle) + tail


def _goal(one: Carrying) -> str:
    turn = f"turn_deg = {one.turn:g}\n" if one.turn else ""
    return GOAL.format(body=one.body, base=one.base, turn=turn)


def new_staff_task(scene: Scene) -> str:
    """Return the hidden part of a task, with nothing in it but comments."""
    x, y, z = (round(mm(value)) for value in above_middle(scene))
    return STAFF_TASK.format(x=x, y=y, z=z)


def above_middle(scene: Scene) -> Vector:
    """Return the point that solutions pass before and after they carry something, in W [m]."""
    place = scene.locations.get("safe")
    return (0.0, 0.0, 0.0) if place is None else place.translation


def new_readme(name: str, task: Task, scene: Scene) -> str:
    """Return the page for students: how to begin, and what the public part of a task asks for."""
    page = README.format(title=one_line(task.title), name=name)
    return written(page, task_words(task, scene))


def quoted(text: str) -> str:
    """Return a text as a TOML string."""
    escaped = one_line(text).replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def _locations(locations: Mapping[str, Pose]) -> str:
    return location_block(locations) if locations else ""
