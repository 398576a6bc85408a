"""A run as messages of ROS 2: read back by Foxglove's library, which knows nothing of vrts."""

from dataclasses import replace
from functools import cache
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader
from scipy.interpolate import CubicHermiteSpline
from scipy.spatial.transform import Rotation

from tests.places import ROOT
from vrts.base.pose import Pose
from vrts.engine.run import Run
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.report.assessment import Assessment
from vrts.report.ros.bag import write_bag
from vrts.report.ros.file import mcap_bytes
from vrts.report.ros.messages import joint_names
from vrts.report.ros.trajectories import TOLERANCE, ways
from vrts.robots.kinematics.batch import flange_frames

EXAMPLES = ROOT / "examples"
HITS = EXAMPLES / "01-cans-on-bases" / "submissions" / "hits-base.v2"
Messages = list[tuple[float, Any]]


@cache
def hits_base() -> Assessment:
    """Return a run in which a can is gripped, carried and hits a base."""
    setting = setting_for(HITS, Where(task=EXAMPLES / "01-cans-on-bases"))
    return assess(request_for(HITS, setting=setting))


@cache
def messages() -> dict[str, Messages]:
    """Return the messages of that run by topic, with their times [s]."""
    found: dict[str, Messages] = {}
    reader = make_reader(BytesIO(mcap_bytes(hits_base())), decoder_factories=[DecoderFactory()])
    for _, channel, record, message in reader.iter_decoded_messages():
        found.setdefault(channel.topic, []).append((record.log_time / 1e9, message))
    return found


def run() -> Run:
    found = hits_base().run
    assert found is not None
    return found


def test_joint_states_are_those_of_the_run() -> None:
    states = messages()["/joint_states"]
    assert len(states) == int(100 * run().horizon_s) + 2  # a hundred a second, and the end
    for time_s, state in states[::37]:
        stamp = state.header.stamp
        assert stamp.sec + stamp.nanosec / 1e9 == pytest.approx(time_s, abs=1e-9)
        here = run().at(time_s)
        assert list(state.name) == [*(f"joint_{k}" for k in range(1, 7)), "hand"]
        assert np.abs(np.array(state.position[:6]) - np.array(here.configuration)).max() < 1e-7
        assert state.position[6] == pytest.approx(here.hand_opening, abs=1e-8)


def matrix(transform: Any) -> np.ndarray[Any, Any]:
    found = np.eye(4)
    q, p = transform.rotation, transform.translation
    found[:3, :3] = Rotation.from_quat([q.x, q.y, q.z, q.w]).as_matrix()
    found[:3, 3] = [p.x, p.y, p.z]
    return found


def of_pose(X: Pose) -> np.ndarray[Any, Any]:
    found = np.eye(4)
    found[:3, :3], found[:3, 3] = np.array(X.rotation).reshape(3, 3), X.translation
    return found


def test_frames_lead_from_the_world_to_flange_and_can() -> None:
    ((_, still),) = messages()["/tf_static"]
    for time_s, message in messages()["/tf"][::53]:
        frames = {t.child_frame_id: t for t in [*still.transforms, *message.transforms]}
        found, frame = np.eye(4), "flange"
        while frame != "world":
            found = matrix(frames[frame].transform) @ found
            frame = frames[frame].header.frame_id
        here = run().at(time_s)
        rotations, origins = flange_frames(run().scene.robot.arm, np.array([here.configuration]))
        assert np.abs(found[:3, :3] - rotations[0]).max() < 1e-5
        assert np.abs(found[:3, 3] - origins[0]).max() < 1e-5
        can = matrix(frames["can1"].transform)
        assert np.abs(can - of_pose(here.poses["can1"])).max() < 1e-5
    fixed = {t.child_frame_id for t in still.transforms}
    assert {"base_link", "table", "base1", "base2"} <= fixed


@pytest.mark.parametrize(
    "program",
    [
        HITS,
        pytest.param(EXAMPLES / "03-around-obstacles" / "solution.v2", marks=pytest.mark.thorough),
    ],
)
def test_a_controller_that_joins_points_by_cubics_follows_the_run(program: Path) -> None:
    found = assess(request_for(program)).run if program != HITS else run()
    assert found is not None
    covered = 0.0
    for way in ways(found):
        spline = CubicHermiteSpline(way.times, way.positions, way.velocities)
        times = np.linspace(0.0, float(way.times[-1]), 700)
        joints = np.array([found.at(way.start_s + t).configuration for t in times.tolist()])
        assert np.abs(spline(times) - joints).max() < 2.0 * TOLERANCE
        assert (way.velocities[[0, -1]] == 0.0).all()
        assert (np.diff(way.times) > 0.0).all()
        covered += way.end_s - way.start_s
    moving = [m for m in found.motions if m.end_s > m.start_s]
    assert covered >= 0.99 * sum(m.end_s - m.start_s for m in moving if not m.blended)


def test_trajectories_are_the_ways() -> None:
    sent = messages()["/joint_trajectory"]
    for (time_s, message), way in zip(sent, ways(run()), strict=True):
        assert time_s == pytest.approx(way.start_s, abs=1e-9)
        last = message.points[-1]
        lasts_s = last.time_from_start.sec + last.time_from_start.nanosec / 1e9
        assert lasts_s == pytest.approx(way.end_s - way.start_s, abs=1e-8)
        assert np.array_equal([p.positions for p in message.points], way.positions)


def test_a_contact_is_a_marker_with_its_words_while_it_lasts() -> None:
    judgement = hits_base().judgement
    assert judgement is not None
    assert judgement.collisions is not None
    (contact,) = judgement.collisions.contacts
    sent = [(t, m) for t, found in messages()["/contacts"] for m in found.markers]
    ball = next((t, m) for t, m in sent if m.ns == "contacts")
    assert ball[0] == pytest.approx(contact.start_s, abs=1e-9)
    place = ball[1].pose.position
    assert (place.x, place.y, place.z) == pytest.approx(contact.point)
    lifetime = ball[1].lifetime.sec + ball[1].lifetime.nanosec / 1e9
    assert lifetime == pytest.approx(max(contact.end_s - contact.start_s, 0.2), abs=1e-8)
    words = [m.text for _, m in sent if m.ns == "contacts in words"]
    assert words
    assert words[0].startswith("can1 touches base1")


def test_every_piece_that_is_tested_is_drawn_in_its_frame() -> None:
    ((_, drawn),) = messages()["/shapes"]
    frames = {marker.header.frame_id for marker in drawn.markers}
    assert {"base_link", "link_2", "link_3", "flange", "left_finger", "can1", "table"} <= frames
    for marker in drawn.markers:
        assert marker.type == 11  # TRIANGLE_LIST
        assert len(marker.points) % 3 == 0
        assert marker.points
        assert min(marker.color.r, marker.color.g, marker.color.b) >= 0.0
        assert max(marker.color.r, marker.color.g, marker.color.b) <= 1.0


def test_the_log_names_lines_and_the_contact() -> None:
    rows = [m for _, m in messages()["/rosout"]]
    assert all(row.file == "hits-base.v2" for row in rows)
    errors = [(row.line, row.msg) for row in rows if row.level == 40]
    assert any(line == 11 and "can1 touches base1" in words for line, words in errors)


def test_the_same_run_gives_the_same_bytes(tmp_path: Path) -> None:
    first, second = (write_bag(hits_base(), tmp_path / name / "run") for name in ("a", "b"))
    assert first.read_bytes() == second.read_bytes() == mcap_bytes(hits_base())
    assert str(tmp_path).encode() not in first.read_bytes()


def test_the_folder_is_a_bag(tmp_path: Path) -> None:
    write_bag(hits_base(), tmp_path / "run")
    with AnyReader([tmp_path / "run"]) as bag:
        assert set(bag.topics) == set(messages())
        assert bag.duration == pytest.approx(1e9 * run().horizon_s, abs=2)


def test_only_arms_of_universal_robots_have_the_names_of_their_driver() -> None:
    arm = run().scene.robot.arm
    assert joint_names(replace(arm, name="ur5"))[0] == "shoulder_pan_joint"
    assert joint_names(replace(arm, name="urban"))[0] == "joint_1"
