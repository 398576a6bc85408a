"""What a sensor sees: centres of mass and the tip of the tool, faces included, nothing else."""

import pytest

from tests.places import ROOT
from vrts.base.pose import IDENTITY, X_AXIS, Pose, Vector, rotation_about, translation
from vrts.base.source import SourceFile
from vrts.scene.model import Region, Sensor
from vrts.scene.reading.scene_file import read_scene
from vrts.scene.sensors import holds, is_on, movable_centres, sees

REGION = Region((0.5, -0.1, 0.0), (0.7, 0.1, 0.2))
AWAY = translation(5.0, 5.0, 5.0)
CENTRES: dict[str, Vector] = {"can1": (0.0, 0.0, 0.05), "can2": (0.0, 0.0, 0.05)}


def at(x: float, y: float, z: float) -> Pose:
    """Return a pose on its side: the centre of mass is 50 mm towards -y."""
    return Pose(rotation_about(X_AXIS, 1.5707963267948966), (x, y, z))


@pytest.mark.parametrize(
    ("y", "inside"), [(0.0, True), (0.149, True), (0.151, False), (-0.051, False), (-0.049, True)]
)
def test_a_body_is_seen_while_its_centre_of_mass_is_inside(y: float, *, inside: bool) -> None:
    where = {"can1": at(0.6, y, 0.1), "can2": AWAY}
    assert sees(Sensor(1001, REGION), where, CENTRES, AWAY) is inside


def test_only_what_a_sensor_names_is_seen() -> None:
    where = {"can1": AWAY, "can2": at(0.6, 0.05, 0.1)}
    assert sees(Sensor(1001, REGION, ()), where, CENTRES, AWAY)
    assert sees(Sensor(1001, REGION, ("can1", "can2")), where, CENTRES, AWAY)
    assert not sees(Sensor(1001, REGION, ("can1",)), where, CENTRES, AWAY)
    assert not sees(Sensor(1001, REGION, ("tool",)), where, CENTRES, AWAY)


def test_the_tool_is_seen_at_its_tip_and_only_when_named() -> None:
    where = {"can1": AWAY, "can2": AWAY}
    X_WT = translation(0.6, 0.0, 0.1)
    assert sees(Sensor(1001, REGION, ("tool",)), where, CENTRES, X_WT)
    assert sees(Sensor(1001, REGION, ("can1", "tool")), where, CENTRES, X_WT)
    assert not sees(Sensor(1001, REGION), where, CENTRES, X_WT)


def test_an_inverted_sensor_is_on_while_nothing_is_inside() -> None:
    inside, outside = translation(0.6, 0.0, 0.1), AWAY
    for sensor in (Sensor(1001, REGION, ("tool",)), Sensor(1001, REGION, ("tool",), inverted=True)):
        assert is_on(sensor, {}, {}, inside) is not sensor.inverted
        assert is_on(sensor, {}, {}, outside) is sensor.inverted


@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("end", [0, 1])
def test_faces_belong_to_the_region(axis: int, end: int) -> None:
    point = [0.6, 0.0, 0.1]
    point[axis] = REGION[end][axis]
    assert holds(REGION, (point[0], point[1], point[2]))
    point[axis] += 1e-9 if end else -1e-9
    assert not holds(REGION, (point[0], point[1], point[2]))


def test_a_sensor_in_a_scene_without_objects_sees_nothing() -> None:
    assert not sees(Sensor(1001, REGION), {}, {}, IDENTITY)


def test_what_can_be_carried_is_what_a_sensor_looks_for() -> None:
    path = ROOT / "scenes" / "cans-on-bases" / "scene.toml"
    scene, _ = read_scene(SourceFile("scene.toml", path.read_text(encoding="utf-8")))
    assert scene is not None
    centres = movable_centres(scene)
    assert set(centres) == {"can1", "can2"}
    where = {body.name: body.X_WO for body in scene.bodies}
    x, y, z = scene.body("can1").X_WO.apply(centres["can1"])
    region = Region((x - 0.01, y - 0.01, z - 0.01), (x + 0.01, y + 0.01, z + 0.01))
    assert sees(Sensor(1001, region), where, centres, IDENTITY)
    assert not sees(Sensor(1001, region, ("can2",)), where, centres, IDENTITY)
