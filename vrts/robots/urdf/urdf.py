"""A six-axis arm from a URDF description: its joints, limits and the shapes of its links.

Reads text only; meshes are asked for by the name the file gives them. Every joint's frame is turned
so that its axis is z, as `SerialArm` wants it.
"""

import math
from typing import NamedTuple

from vrts.base.pose import (
    IDENTITY,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Pose,
    Rotation,
    Vector,
    cross,
    dot,
    multiply,
    rotation_about,
    scale,
)
from vrts.robots.urdf.xml_tree import Element, XmlFault, read_xml

JOINTS = 6
TURNING = ("revolute", "continuous")
FULL_TURN = math.tau  # [rad] limit either way of a joint without limits [assumed]
QUARTER = 1e-9  # [rad] an angle this near to quarter turns is one: files write 12 digits
FLANGES = ("tool0", "flange", "tool_flange")  # links that are the flange unless another is named
FARTHEST = 100.0  # [m] any length
MOST_SHAPES = 100  # of all links


class UrdfFault(Exception):  # noqa: N818 -- names what it is
    """A description does not give an arm that can be simulated."""

    def __init__(self, message: str, line: int | None = None) -> None:
        """Say what is wrong, and where if it is at one place."""
        super().__init__(message)
        self.message = message
        self.line = line


class Shape(NamedTuple):
    """A collision element of a link."""

    kind: str  # "box", "cylinder", "sphere" or "mesh"
    size: tuple[float, ...]  # edges; radius and length; radius; scale along x, y and z
    file: str  # of a mesh, as the description names it
    X_LP: Pose  # in the frame L_k it moves with
    line: int


class Part(NamedTuple):
    """What moves with one joint."""

    name: str  # of the URDF link
    joint: int  # 0 is the base
    shapes: tuple[Shape, ...]


class Description(NamedTuple):
    """An arm as its file describes it."""

    name: str
    joints: tuple[Pose, ...]  # of L_k in L_(k-1) at zero
    X_LF: Pose
    lower: tuple[float, ...]  # [rad]
    upper: tuple[float, ...]  # [rad]
    speed: tuple[float, ...]  # [rad/s]; 0 where the file gives none
    joint_names: tuple[str, ...]
    parts: tuple[Part, ...]


class _Joint(NamedTuple):
    name: str
    turning: bool
    parent: str
    child: str
    X_PC: Pose  # child in parent, at zero
    axis: Vector
    lower: float
    upper: float
    speed: float
    line: int


class _Placed(NamedTuple):
    """A link of the file in the frame L_k it moves with."""

    joint: int
    X_LU: Pose


def read_urdf(data: bytes, flange: str | None = None) -> Description:
    """Return the arm that a URDF file describes.

    Args:
        data: The file.
        flange: Name of the link whose frame is the flange: z out of it. None: `tool0` or
            `flange`, else the link behind the last joint.

    Raises:
        UrdfFault: The file is not URDF, or the arm does not have six turning joints in a row.
    """
    try:
        root = read_xml(data)
    except XmlFault as fault:
        raise UrdfFault(fault.message, fault.line) from fault
    if root.tag != "robot":
        raise UrdfFault(f"the file describes a `{root.tag}`, not a `robot`", root.line)
    links = _links(root)
    joints = _root_first(_joints(root, links))
    name = flange or _flange(links, joints)
    if name not in links:
        raise UrdfFault(f"there is no link `{name}`")
    moving = _in_a_row(joints, name)
    placed, frames = _placed(links, joints, moving)
    if placed[name].joint != JOINTS:
        raise UrdfFault(f"`{name}` is not behind the sixth joint")
    return Description(
        root.attributes.get("name") or "robot",
        frames,
        placed[name].X_LU,
        tuple(joint.lower for joint in moving),
        tuple(joint.upper for joint in moving),
        tuple(joint.speed for joint in moving),
        tuple(joint.name for joint in moving),
        _parts(links, placed),
    )


def _links(root: Element) -> dict[str, Element]:
    found: dict[str, Element] = {}
    for link in root.all("link"):
        name = link.attributes.get("name", "")
        if not name or name in found:
            fault = f"another link is called `{name}`" if name else "a link has no name"
            raise UrdfFault(fault, link.line)
        found[name] = link
    if not found:
        raise UrdfFault("there are no links", root.line)
    return found


def _joints(root: Element, links: dict[str, Element]) -> tuple[_Joint, ...]:
    found: list[_Joint] = []
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


def _joint(element: Element, links: dict[str, Element]) -> _Joint:
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
        speed = _number(limit, "velocity", 0.0)
        if kind == "revolute":
            lower, upper = _number(limit, "lower", 0.0), _number(limit, "upper", 0.0)
    elif kind == "revolute":
        raise UrdfFault(f"joint `{name}` has no limits", element.line)
    if turning and not -10 * math.tau <= lower < upper <= 10 * math.tau:
        raise UrdfFault(f"the limits of joint `{name}` are not a range", element.line)
    if speed < 0.0:
        raise UrdfFault(f"the speed of joint `{name}` is negative", element.line)
    axis_element = element.first("axis")
    axis = X_AXIS if axis_element is None else _vector(axis_element, "xyz", X_AXIS)
    size = math.hypot(*axis)
    if turning and size < 1e-6:
        raise UrdfFault(f"the axis of joint `{name}` has no direction", element.line)
    axis = scale(axis, 1.0 / size) if turning else Z_AXIS
    X_PC = _origin(element)
    return _Joint(name, turning, ends[0], ends[1], X_PC, axis, lower, upper, speed, element.line)


def _flange(links: dict[str, Element], joints: tuple[_Joint, ...]) -> str:
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


def _in_a_row(joints: tuple[_Joint, ...], flange: str) -> tuple[_Joint, ...]:
    """Return the six turning joints from the root to the flange."""
    by_child = {joint.child: joint for joint in joints}
    row: list[_Joint] = []
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


def _placed(
    links: dict[str, Element], joints: tuple[_Joint, ...], moving: tuple[_Joint, ...]
) -> tuple[dict[str, _Placed], tuple[Pose, ...]]:
    """Return every link in the frame it moves with, and the frames L_1 to L_6 in those before."""
    children = {joint.child for joint in joints}
    root = next(link for link in links if link not in children)
    found = {root: _Placed(0, IDENTITY)}
    frames: dict[int, Pose] = {}
    for joint in joints:
        at = found[joint.parent]
        X_LC = at.X_LU @ joint.X_PC
        if not joint.turning:
            found[joint.child] = _Placed(at.joint, X_LC)
            continue
        number = moving.index(joint) + 1
        align = Pose(_from_z(joint.axis), (0.0, 0.0, 0.0))  # L_k in the link's own frame
        frames[number] = _clean(X_LC @ align)
        found[joint.child] = _Placed(number, align.inverse())
    return found, tuple(frames[number] for number in range(1, JOINTS + 1))


def _root_first(joints: tuple[_Joint, ...]) -> tuple[_Joint, ...]:
    """Return the joints so that every parent comes before its children."""
    below: dict[str, list[_Joint]] = {}
    for joint in joints:
        below.setdefault(joint.parent, []).append(joint)
    children = {joint.child for joint in joints}
    pending = [link for link in below if link not in children]
    found: list[_Joint] = []
    while pending:
        for joint in below.get(pending.pop(0), ()):
            found.append(joint)
            pending.append(joint.child)
    if len(found) != len(joints):
        raise UrdfFault("the joints lead round in a circle")
    return tuple(found)


def _parts(links: dict[str, Element], placed: dict[str, _Placed]) -> tuple[Part, ...]:
    found = [
        Part(
            name,
            placed[name].joint,
            tuple(_shape(element, placed[name].X_LU) for element in link.all("collision")),
        )
        for name, link in links.items()
    ]
    if sum(len(part.shapes) for part in found) > MOST_SHAPES:
        raise UrdfFault(f"more than {MOST_SHAPES} shapes; simplify them")
    return tuple(sorted(found, key=lambda part: part.joint))


def _shape(collision: Element, X_LU: Pose) -> Shape:
    X_LP = _clean(X_LU @ _origin(collision))
    geometry = collision.first("geometry")
    for element in [] if geometry is None else geometry.children:
        line = element.line
        match element.tag:
            case "box":
                size = _vector(element, "size", None)
                return Shape("box", _positive(size, element), "", X_LP, line)
            case "cylinder":
                size = (_number(element, "radius", None), _number(element, "length", None))
                return Shape("cylinder", _positive(size, element), "", X_LP, line)
            case "sphere":
                size = (_number(element, "radius", None),)
                return Shape("sphere", _positive(size, element), "", X_LP, line)
            case "mesh":
                factors = _vector(element, "scale", (1.0, 1.0, 1.0))
                return Shape("mesh", factors, element.attributes.get("filename", ""), X_LP, line)
            case _:
                pass
    raise UrdfFault("a collision has no box, cylinder, sphere or mesh", collision.line)


def _positive(size: tuple[float, ...], element: Element) -> tuple[float, ...]:
    if min(size) <= 0.0:
        raise UrdfFault(f"a `{element.tag}` has no size", element.line)
    return size


def _origin(element: Element) -> Pose:
    origin = element.first("origin")
    if origin is None:
        return IDENTITY
    roll, pitch, yaw = _vector(origin, "rpy", (0.0, 0.0, 0.0))
    turn = multiply(
        rotation_about(Z_AXIS, yaw),
        multiply(rotation_about(Y_AXIS, pitch), rotation_about(X_AXIS, roll)),
    )
    return _clean(Pose(turn, _vector(origin, "xyz", (0.0, 0.0, 0.0))))


def _from_z(axis: Vector) -> Rotation:
    """Return the smallest rotation that carries z into a unit vector."""
    across = cross(Z_AXIS, axis)
    sine, cosine = math.hypot(*across), dot(Z_AXIS, axis)
    if sine < QUARTER:
        return rotation_about(X_AXIS, 0.0 if cosine > 0.0 else math.pi)
    return _clean(
        Pose(rotation_about(scale(across, 1.0 / sine), math.atan2(sine, cosine)), (0.0, 0.0, 0.0))
    ).rotation


def _clean(X: Pose) -> Pose:
    """Return a pose, its quarter turns exact: files write them with 12 digits."""
    nearest = [float(round(entry)) for entry in X.rotation]
    if any(abs(a - b) > QUARTER for a, b in zip(X.rotation, nearest, strict=True)):
        return X
    r0, r1, r2, r3, r4, r5, r6, r7, r8 = (entry + 0.0 for entry in nearest)
    return Pose((r0, r1, r2, r3, r4, r5, r6, r7, r8), X.translation)


def _number(element: Element, key: str, default: float | None) -> float:
    text = element.attributes.get(key)
    if text is None:
        if default is None:
            raise UrdfFault(f"a `{element.tag}` has no `{key}`", element.line)
        return default
    return _numbers(text, 1, element, key)[0]


def _vector(element: Element, key: str, default: Vector | None) -> Vector:
    text = element.attributes.get(key)
    if text is None:
        if default is None:
            raise UrdfFault(f"a `{element.tag}` has no `{key}`", element.line)
        return default
    x, y, z = _numbers(text, 3, element, key)
    return (x, y, z)


def _numbers(text: str, count: int, element: Element, key: str) -> tuple[float, ...]:
    words = text.split()
    try:
        values = tuple(float(word) for word in words)
    except ValueError:
        values = ()
    if len(values) != count or not all(abs(value) <= FARTHEST for value in values):
        wanted = "a number" if count == 1 else f"{count} numbers"
        raise UrdfFault(f"`{key}` of a `{element.tag}` is not {wanted}", element.line)
    return values
