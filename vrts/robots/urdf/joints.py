"""The joints of a URDF file: one tree of links, and the six that turn one behind the other."""

import math
from typing import NamedTuple

from vrts.base.pose import X_AXIS, Z_AXIS, Pose, Vector, scale
from vrts.robots.urdf.description import JOINTS, UrdfFault
from vrts.robots.urdf.values import number, origin, vector
from vrts.robots.urdf.xml_tree import Element

TURNING = ("revolute", "continuous")
FULL_TURN = math.tau  # [rad] limit either way of a joint without limits [assumed]
FLANGES = ("tool0", "flange", "tool_flange")  # links that are the flange unless another is named


class Joint(NamedTuple):
    """A turning or fixed joint."""

    name: str
    turning: bool
    parent: str
    child: str
    X_PC: Pose  # child in parent, at zero
    axis: Vector  # in the frame of the child; a unit vector
    lower: float  # [rad]
    upper: float  # [rad]
    speed: float  # [rad/s]; 0: the file gives none
    line: int


def read_joints(root: Element, links: dict[str, Element]) -> tuple[Joint, ...]:
    """Return the joints in the order of the file; they make one tree of the links."""
    found: list[Joint] = []
    children: set[str] = set()
    for element in root.all("joint"):
        joint = _joint(element, links)
        if joint.child in children:
            raise UrdfFault(f"link `{joint.child}` hangs on two joints", joint.line)
        children.add(joint.child)
        found.append(joint)
    if len(children) != len(links) - 1:
        loose = sorted(set(links) - children)
        raise UrdfFault(f"the links are not one tree: {', '.join(f'`{n}`' for n in loose[:5])}")
    return tuple(found)


def _joint(element: Element, links: dict[str, Element]) -> Joint:
    name = element.attributes.get("name", "")
    ends: list[str] = []
    for tag in ("parent", "child"):
        end = element.first(tag)
        link = "" if end is None else end.attributes.get("link", "")
        if link not in links:
            raise UrdfFault(f"joint `{name}` has no {tag} link", element.line)
        ends.append(link)
    kind = element.attributes.get("type", "")
    turning = kind in TURNING
    if not turning and kind != "fixed":
        raise UrdfFault(f"joint `{name}` is `{kind}`: only turning and fixed joints", element.line)
    if element.first("mimic") is not None:
        raise UrdfFault(f"joint `{name}` follows another joint", element.line)
    lower, upper, speed = (-FULL_TURN, FULL_TURN, 0.0) if turning else (0.0, 0.0, 0.0)
    limit = element.first("limit")
    if turning and limit is not None:
        speed = number(limit, "velocity", 0.0)
        if kind == "revolute":
            lower, upper = number(limit, "lower", 0.0), number(limit, "upper", 0.0)
    elif kind == "revolute":
        raise UrdfFault(f"joint `{name}` has no limits", element.line)
    if turning and not -10 * math.tau <= lower < upper <= 10 * math.tau:
        raise UrdfFault(f"the limits of joint `{name}` are not a range", element.line)
    if speed < 0.0:
        raise UrdfFault(f"the speed of joint `{name}` is negative", element.line)
    axis_element = element.first("axis")
    axis = X_AXIS if axis_element is None else vector(axis_element, "xyz", X_AXIS)
    size = math.hypot(*axis)
    if turning and size < 1e-6:
        raise UrdfFault(f"the axis of joint `{name}` has no direction", element.line)
    axis = scale(axis, 1.0 / size) if turning else Z_AXIS
    X_PC = origin(element)
    return Joint(name, turning, ends[0], ends[1], X_PC, axis, lower, upper, speed, element.line)


def root_first(joints: tuple[Joint, ...]) -> tuple[Joint, ...]:
    """Return the joints so that every parent comes before its children."""
    below: dict[str, list[Joint]] = {}
    for joint in joints:
        below.setdefault(joint.parent, []).append(joint)
    children = {joint.child for joint in joints}
    pending = [link for link in below if link not in children]
    found: list[Joint] = []
    while pending:
        for joint in below.get(pending.pop(0), ()):
            found.append(joint)
            pending.append(joint.child)
    if len(found) != len(joints):
        raise UrdfFault("the joints lead round in a circle")
    return tuple(found)


def flange_of(links: dict[str, Element], joints: tuple[Joint, ...]) -> str:
    """Return a link of a usual name, else the child of the last turning joint from the root."""
    for name in FLANGES:
        if name in links:
            return name
    depth = dict.fromkeys(links, 0)
    for joint in joints:
        depth[joint.child] = depth[joint.parent] + joint.turning
    turning = [joint for joint in joints if joint.turning]
    if not turning:
        raise UrdfFault("no joint turns")
    return max(turning, key=lambda joint: depth[joint.child]).child


def in_a_row(joints: tuple[Joint, ...], flange: str) -> tuple[Joint, ...]:
    """Return the six turning joints from the root to the flange."""
    by_child = {joint.child: joint for joint in joints}
    row: list[Joint] = []
    link = flange
    while link in by_child:
        joint = by_child[link]
        if joint.turning:
            row.append(joint)
        link = joint.parent
    aside = [joint for joint in joints if joint.turning and joint not in row]
    if aside:
        raise UrdfFault(f"joint `{aside[0].name}` does not lead to `{flange}`", aside[0].line)
    if len(row) != JOINTS:
        raise UrdfFault(f"{len(row)} joints turn on the way to `{flange}`; an arm has {JOINTS}")
    return tuple(reversed(row))
