"""An arm as it stands beside what its controller counts with: the frames that follow, and bounds.

Commanded joints turn in the frames of the arm as it stands. What a joint stands off is a turn about
its own axis, a link a longer step to the next, the tool a shift of the hand, the base a shift and a
turn of the whole arm.
"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import NamedTuple

from vrts.base.pose import Z_AXIS, Pose, Vector, rotation_about, scale, translation
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.robots.kinematics.chain import fixed_frames
from vrts.robots.model import (
    NO_JOINTS,
    Arm,
    Built,
    Configuration,
    Off,
    Robot,
    SphericalWristArm,
    Within,
    flange_in_hand,
)

LINKS = ("a2", "a3", "d2", "d4")  # of the PUMA family; d6 is the tool along Z
AXES = "XYZ"
JOINTS = tuple(f"joint {k}" for k in range(1, 7))
NAMES = {  # of every number of `Off`, field by field
    "shown": JOINTS,
    "zeros": tuple(f"the zero of {joint}" for joint in JOINTS),
    "links": tuple(f"link {link}" for link in LINKS),
    "tool": tuple(f"{axis} of the tool" for axis in AXES),
    "base": tuple(f"{axis} of the base" for axis in AXES),
    "turn": tuple(f"the turn of the base about {axis}" for axis in AXES),
}


class Standing(NamedTuple):
    """A way in which an arm may stand."""

    what: str  # "joint 3 at the upper end of its interval"
    off: Off


def as_built(arm: Arm, off: Off, within: Within | None = None) -> Arm:
    """Return an arm that stands otherwise than its controller counts.

    Args:
        arm: With the numbers of the controller; how it stood before does not count.
        off: What stands otherwise.
        within: How far that may be from the truth; None: as the arm says already.
    """
    if within is None:
        within = Within() if arm.built is None else arm.built.within
    arm = replace(arm, built=None)
    real = arm
    if isinstance(arm, SphericalWristArm):
        longer = zip(LINKS, off.links, strict=True)
        real = replace(arm, **{link: getattr(arm, link) + by for link, by in longer})
    frames = [
        frame @ Pose(rotation_about(Z_AXIS, shown + zero), (0.0, 0.0, 0.0))
        for frame, shown, zero in zip(fixed_frames(real), off.shown, off.zeros, strict=True)
    ]
    frames[0] = _whole(off) @ frames[0]
    return replace(arm, built=Built(tuple(frames), real.X_LF @ translation(*off.tool), off, within))


def _whole(off: Off) -> Pose:
    """Return where the whole arm stands in W."""
    angle = math.hypot(*off.turn)
    if angle == 0.0:
        return translation(*off.base)
    return Pose(rotation_about(scale(off.turn, 1.0 / angle), angle), off.base)


def shown_off(arm: Arm) -> Configuration:
    """Return what encoders show beside what is commanded [rad]."""
    return NO_JOINTS if arm.built is None else arm.built.off.shown


def at_the_ends(built: Built) -> Iterator[Standing]:
    """Yield how an arm may stand: each number alone at both ends of its interval."""
    for field, names in NAMES.items():
        values, halves = getattr(built.off, field), getattr(built.within.off, field)
        for place, (name, half) in enumerate(zip(names, halves, strict=True)):
            if not half:
                continue
            for by, end in ((-half, "lower"), (half, "upper")):
                other = (*values[:place], values[place] + by, *values[place + 1 :])
                what = f"{name} at the {end} end of its interval"
                yield Standing(what, built.off._replace(**{field: other}))


def doubt_m(robot: Robot, held: Iterable[float] = ()) -> float:
    """Return how far any point of the robot may be from where it is found to be, at most [m].

    Every number may be anywhere in its interval, all at once. A turn moves a point by no more than
    its angle times the largest distance of the point from its axis, a length by no more than
    itself; so the sum of all is a bound, in every configuration.

    Args:
        robot: Arm and hand.
        held: How far what the hand carries reaches from the flange's origin [m].
    """
    built = robot.arm.built
    if built is None:
        return 0.0
    off = built.within.off
    lengths = math.fsum((*off.links, math.hypot(*off.tool), math.hypot(*off.base)))
    reach = [far + lengths for far in _reaches(robot, held)]
    turns = zip(off.shown, off.zeros, reach[1:], strict=True)
    joints = math.fsum((shown + zero) * far for shown, zero, far in turns)
    return lengths + joints + math.hypot(*off.turn) * reach[0]


def _reaches(robot: Robot, held: Iterable[float]) -> list[float]:
    """Return how far from the origins of L_0 .. L_6 what turns with them reaches [m]."""
    arm, hand = robot.arm, robot.gripper
    own = [0.0] * 7
    for link in arm.links:
        own[link.joint] = max([own[link.joint], *map(_far, link.pieces)])
    fingers = [_far(piece) + 0.5 * hand.opening_max for one in hand.fingers for piece in one.pieces]
    palm = max([*map(_far, hand.body), *fingers, *held], default=0.0)
    own[6] = max(own[6], math.hypot(*flange_in_hand(arm).translation) + palm)
    found = [own[6]]
    for joint in range(5, -1, -1):
        step = math.hypot(*fixed_frames(arm)[joint].translation)
        found.append(max(own[joint], found[-1] + step))
    return found[::-1]


def _far(piece: Piece) -> float:
    """Return how far a piece reaches from the origin of its body [m]."""
    shape, X = piece
    if isinstance(shape, Box):
        return math.hypot(*X.translation) + math.hypot(*shape.half_extents)
    if isinstance(shape, Cylinder):
        return math.hypot(*X.translation) + math.hypot(shape.radius, shape.half_length)
    return max(math.hypot(*X.apply(point)) for point in shape.points)


def reach_of(pieces: Iterable[Piece], origin: Vector) -> float:
    """Return how far a body reaches from a point [m], where its own origin is `origin` from it."""
    return math.hypot(*origin) + max(map(_far, pieces), default=0.0)
