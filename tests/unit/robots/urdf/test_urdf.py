"""Arms from URDF: what is read, what is refused and why."""

import math
import struct

import pytest

from tests.places import ROOT
from vrts.base.pose import Pose, rotation_angle
from vrts.geometry.shapes import Box, Cylinder, Hull
from vrts.robots.kinematics.kinematics import forward
from vrts.robots.model import Configuration
from vrts.robots.urdf.description import UrdfFault
from vrts.robots.urdf.reader import read_urdf
from vrts.robots.urdf.serial_robot import Manner, serial_robot
from vrts.robots.urdf.stl import stl_points
from vrts.robots.urdf.xml_tree import MOST_DEPTH, MOST_ELEMENTS, XmlFault, read_xml

ARM = ROOT / "scenes" / "one-can-urdf" / "arm.urdf"
TEXT = ARM.read_text("utf-8")
READY: Configuration = (0.0, 0.0, 0.0, 0.0, math.pi / 2, 0.0)
MANNER = Manner("small_arm", "A small arm", READY, 0.6, 0.5, 1.5)


def no_mesh(name: str) -> bytes:
    raise AssertionError(f"{name} is not asked for")


def changed(before: str, after: str) -> bytes:
    assert TEXT.count(before) >= 1
    return TEXT.replace(before, after, 1).encode()


def tetrahedron(size: float) -> bytes:
    """Return a mesh as text: the corner of a cube."""
    corners = [(0, 0, 0), (size, 0, 0), (0, size, 0), (0, 0, size)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    lines = ["solid corner"]
    for face in faces:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(map(str, corners[k])) for k in face]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid"]).encode()


def test_joints_and_flange_are_where_the_file_has_them() -> None:
    robot = serial_robot(read_urdf(TEXT.encode()), MANNER, no_mesh)
    X_BF = forward(robot.arm, (0.0,) * 6)  # type: ignore[arg-type]
    assert X_BF.translation == pytest.approx((0.05 + 0.40 + 0.08, 0.0, 0.22 + 0.16 + 0.42 + 0.09))
    assert X_BF.approach == pytest.approx((1.0, 0.0, 0.0), abs=1e-12)
    down = forward(robot.arm, READY)
    assert down.approach == pytest.approx((0.0, 0.0, -1.0), abs=1e-12)
    assert robot.arm.shoulder_height == 0.6
    assert robot.arm.upper[5] == 6.2
    assert robot.arm.speed[3] == 4.0


def test_links_move_with_their_joints_and_the_base_comes_first() -> None:
    arm = serial_robot(read_urdf(TEXT.encode()), MANNER, no_mesh).arm
    assert [(link.name, link.joint) for link in arm.links] == [
        ("base", 0),
        ("shoulder", 1),
        ("upper arm", 2),
        ("elbow", 3),
        ("forearm", 4),
        ("wrist", 5),
        ("plate", 6),
    ]
    assert isinstance(arm.links[0].pieces[1].shape, Cylinder)  # the column
    assert isinstance(arm.links[2].pieces[0].shape, Box)


def test_a_ball_is_held_by_its_hull() -> None:
    arm = serial_robot(read_urdf(TEXT.encode()), MANNER, no_mesh).arm
    hull = arm.links[3].pieces[0].shape
    assert isinstance(hull, Hull)
    sizes = [math.hypot(*point) for point in hull.points]
    assert min(sizes) > 0.075
    assert max(sizes) < 0.081


def test_quarter_turns_are_exact() -> None:
    arm = read_urdf(TEXT.encode())
    for frame in (*arm.joints, arm.X_LF):
        assert all(entry in (-1.0, 0.0, 1.0) for entry in frame.rotation)


def test_slanted_axes_are_kept() -> None:
    slanted = read_urdf(changed('<axis xyz="1 0 0"/>', '<axis xyz="1 1 0.5"/>'))
    frame = slanted.joints[3]
    turn = rotation_angle(frame.rotation, Pose(slanted.joints[2].rotation, (0, 0, 0)).rotation)
    assert turn > 0.1
    robot = serial_robot(slanted, MANNER, no_mesh)
    q: Configuration = (0.0, 0.0, 0.0, 2.0, 0.0, 0.0)
    assert forward(robot.arm, q).translation != pytest.approx(forward(robot.arm, READY).translation)


def test_a_mesh_becomes_its_hull() -> None:
    text = changed('<box size="0.12 0.08 0.56"/>', '<mesh filename="corner.stl" scale="2 2 2"/>')
    arm = serial_robot(read_urdf(text), MANNER, lambda name: tetrahedron(0.1)).arm
    hull = arm.links[2].pieces[0].shape
    assert isinstance(hull, Hull)
    found = sorted(tuple(round(part, 9) for part in point) for point in hull.points)
    assert found == [(0, 0, 0), (0, 0, 0.2), (0, 0.2, 0), (0.2, 0, 0)]


JOINT = '<joint name="joint_6" type="revolute">'
LIMIT = '<limit lower="-2.9" upper="2.9" velocity="2.5" effort="100"/>'
FAULTS = [
    ("<robot name", "<model name", "not XML"),
    ('<?xml version="1.0"?>', '<?xml version="1.0"?><!DOCTYPE x []>', "document type"),
    (JOINT, '<joint name="joint_6" type="prismatic">', "`prismatic`"),
    (JOINT, '<joint name="joint_6" type="fixed">', "5 joints turn"),
    (JOINT, JOINT + '<mimic joint="joint_1"/>', "follows another"),
    (LIMIT, "", "no limits"),
    (LIMIT, LIMIT.replace("2.5", "-1"), "negative"),
    (LIMIT, LIMIT.replace('"-2.9"', '"2.9"'), "not a range"),
    (LIMIT, LIMIT.replace('"-2.9"', '"x"'), "not a number"),
    (LIMIT, LIMIT.replace('"-2.9"', '"nan"'), "not a number"),
    ('<axis xyz="0 0 1"/>', '<axis xyz="0 0 0"/>', "no direction"),
    ('<axis xyz="0 0 1"/>', '<axis xyz="0 0"/>', "not 3 numbers"),
    ('<child link="shoulder_link"/>', '<child link="elbow_link"/>', "two joints"),
    ('<child link="shoulder_link"/>', '<child link="nothing"/>', "no child link"),
    ('<parent link="base_link"/>', '<parent link="plate_link"/>', "circle"),
    ('<link name="tool0"/>', '<link name="tool0"/><link name="loose"/>', "one tree"),
    ('<link name="tool0"/>', '<link name="base_link"/>', "called `base_link`"),
    ('<cylinder radius="0.10" length="0.22"/>', '<cylinder radius="0.10"/>', "no `length`"),
    ('<cylinder radius="0.10" length="0.22"/>', '<cylinder radius="0" length="1"/>', "no size"),
    ('<cylinder radius="0.10" length="0.22"/>', '<cone radius="1"/>', "no box, cylinder"),
]


@pytest.mark.parametrize(("before", "after", "words"), FAULTS, ids=[f[2] for f in FAULTS])
def test_a_fault_is_named(before: str, after: str, words: str) -> None:
    with pytest.raises(UrdfFault, match=words):
        read_urdf(changed(before, after))


def test_a_fault_has_its_line() -> None:
    with pytest.raises(UrdfFault) as found:
        read_urdf(changed(JOINT, '<joint name="joint_6" type="floating">'))
    line = found.value.line
    assert line is not None
    assert "joint_6" in TEXT.splitlines()[line - 1]


def test_the_flange_is_a_link_behind_the_sixth_joint() -> None:
    assert read_urdf(TEXT.encode(), "plate_link").X_LF.translation == (0.0, 0.0, 0.0)
    with pytest.raises(UrdfFault, match="no link `hand`"):
        read_urdf(TEXT.encode(), "hand")
    with pytest.raises(UrdfFault, match="does not lead to"):
        read_urdf(TEXT.encode(), "forearm_link")


def test_without_a_usual_name_the_flange_is_the_last_link_that_turns() -> None:
    text = TEXT.replace("tool0", "somewhere").encode()
    assert read_urdf(text).X_LF.translation == (0.0, 0.0, 0.0)


def test_a_joint_without_speed_and_ready_beyond_limits_are_refused() -> None:
    slow = read_urdf(changed(LIMIT, '<limit lower="-2.9" upper="2.9" effort="100"/>'))
    with pytest.raises(UrdfFault, match="no speed"):
        serial_robot(slow, MANNER, no_mesh)
    beyond = MANNER._replace(ready=(4.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    with pytest.raises(UrdfFault, match=r"ready puts joint 1 at 229\.2 degrees"):
        serial_robot(read_urdf(TEXT.encode()), beyond, no_mesh)


def test_continuous_joints_turn_once_either_way() -> None:
    text = changed(JOINT, '<joint name="joint_6" type="continuous">')
    arm = read_urdf(text)
    assert (arm.lower[5], arm.upper[5]) == (-math.tau, math.tau)


BAD_MESHES = [
    (b"", "not STL"),
    (b"solid nothing", "not STL"),
    (tetrahedron(0.1).replace(b"0.1", b"nan"), "not STL"),
    (tetrahedron(1e-5), "flat"),
]


@pytest.mark.parametrize(("data", "words"), BAD_MESHES)
def test_bad_meshes_are_refused(data: bytes, words: str) -> None:
    text = changed('<box size="0.12 0.08 0.56"/>', '<mesh filename="corner.stl"/>')
    with pytest.raises(UrdfFault, match=words):
        serial_robot(read_urdf(text), MANNER, lambda name: data)


def test_binary_meshes_are_read() -> None:
    corners = b"".join(float_bytes(value) for value in (0, 0, 0, 1, 0, 0, 0, 1, 0))
    data = b"solid but binary".ljust(80) + (1).to_bytes(4, "little") + bytes(12) + corners + b"\0\0"
    points = stl_points(data)
    assert points is not None
    assert points.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert stl_points(data[:-1]) is None


def float_bytes(value: float) -> bytes:
    return struct.pack("<f", value)


ENTITIES = b"""<?xml version="1.0"?>
<!DOCTYPE robot [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;">]>
<robot name="&b;"/>"""


def test_entities_are_never_expanded() -> None:
    with pytest.raises(XmlFault, match="document type") as found:
        read_xml(ENTITIES)
    assert found.value.line == 2


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"<a>",
        b"\xff\xfe\x00",
        b"<a>" * (MOST_DEPTH + 2),
        b"<a>" + b"<b/>" * (MOST_ELEMENTS + 1) + b"</a>",
        b"<a/><b/>",
        b'<a name="caf\xe9"/>',
    ],
    ids=["empty", "open", "binary", "deep", "long", "two roots", "latin-1"],
)
def test_what_is_no_small_xml_is_refused(data: bytes) -> None:
    with pytest.raises(XmlFault):
        read_xml(data)


def test_text_is_utf_8_whatever_it_says_of_itself() -> None:
    root = read_xml('<?xml version="1.0" encoding="utf-7"?><a name="é"/>'.encode())
    assert root.attributes == {"name": "é"}


def test_too_many_shapes_are_refused() -> None:
    shape = '<collision><geometry><sphere radius="0.1"/></geometry></collision>'
    with pytest.raises(UrdfFault, match="more than 100 shapes"):
        read_urdf(changed('<link name="tool0"/>', f'<link name="tool0">{100 * shape}</link>'))


def test_links_that_meet_at_ready_are_never_compared() -> None:
    usual = serial_robot(read_urdf(TEXT.encode()), MANNER, no_mesh).arm
    assert usual.skipped_pairs == frozenset()
    long = changed('<box size="0.31 0.08 0.08"/>', '<box size="0.31 0.30 0.08"/>')
    met = serial_robot(read_urdf(long), MANNER, no_mesh).arm
    assert met.skipped_pairs == frozenset({frozenset(("upper arm", "forearm"))})
