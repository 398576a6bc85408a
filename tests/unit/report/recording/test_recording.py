"""Recordings hold the run as it was: what the viewer is sent, and that it opens."""

import math
import re
import socket
import subprocess
import sys
from pathlib import Path
from typing import Any, cast

import numpy as np
from rerun.chunk import RrdReader

from tests.places import ROOT
from vrts.base.pose import rotation_about
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.report.poses.quaternions import quaternions
from vrts.report.poses.sampled import RATE_HZ, times_of
from vrts.report.recording import write_recording
from vrts.report.recording.lanes import states
from vrts.report.recording.names import Array, plain_markdown
from vrts.report.recording.plots import TOLERANCE
from vrts.report.recording.thinning import bends

SOLUTION = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"
TRANSLATION = "Transform3D:translation"
RERUN = Path(sys.executable).parent / "rerun"


def test_quaternions_turn_like_their_matrices() -> None:
    turns = [rotation_about((0.6, 0.0, 0.8), math.pi * k / 7) for k in range(-7, 8)]
    turns += [rotation_about(axis, math.pi) for axis in ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))]
    matrices = np.array(turns).reshape(-1, 3, 3)
    x, y, z, w = quaternions(matrices).astype(float).T
    again = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    ).transpose(2, 0, 1)
    assert np.abs(again - matrices).max() < 1e-6


HITS = SOLUTION.parent / "submissions" / "hits-base.v2"


def test_a_contact_is_marked_and_lines_gripper_and_path_are_there(tmp_path: Path) -> None:
    path = tmp_path / "run.rrd"
    setting = setting_for(HITS, Where(task=SOLUTION.parent))
    write_recording(assess(request_for(HITS, setting=setting)), path)
    shown = subprocess.run(
        [RERUN, "rrd", "print", "-vvv", path], capture_output=True, text=True, check=True
    ).stdout
    assert "can1 touches base1" in shown
    assert "Lines, gripper and signals" in shown, "how the viewer arranges it"
    for entity in ("/world/contacts/1", "/world/tool_path", "/lanes/program", "/lanes/gripper"):
        assert entity in shown
    assert "/range/limit" in shown
    checked = subprocess.run([RERUN, "rrd", "verify", path], capture_output=True, check=False)
    assert checked.returncode == 0, checked.stderr


def test_states_follow_one_another_without_overlap() -> None:
    changes = states([(2.0, 3.0, "b"), (1.0, 2.0, "a")], "empty", 3.0)
    assert changes == [(0.0, "empty"), (1.0, "a"), (2.0, "b")]


def test_a_recording_has_scene_robot_plots_and_log(tmp_path: Path) -> None:
    path = tmp_path / "run.rrd"
    write_recording(assess(request_for(SOLUTION)), path)
    shown = subprocess.run(
        [RERUN, "rrd", "print", "-v", path], capture_output=True, text=True, check=True
    ).stdout
    for entity in (
        "/world/robot/forearm",
        "/world/bodies/can1",
        "/joints",
        "/hand",
        "/log",
        "/summary",
    ):
        assert entity in shown
    assert "Mesh3D" in shown
    checked = subprocess.run(
        [RERUN, "rrd", "verify", path], capture_output=True, text=True, check=False
    )
    assert checked.returncode == 0, checked.stderr


def test_poses_are_sent_only_of_what_moves_and_while_it_moves(tmp_path: Path) -> None:
    path = tmp_path / "run.rrd"
    a = assess(request_for(SOLUTION))
    assert a.run is not None
    write_recording(a, path)
    shown = subprocess.run(
        [RERUN, "rrd", "print", path], capture_output=True, text=True, check=True
    ).stdout
    rows = {
        entity: int(count)
        for count, entity in re.findall(
            r"with (\d+) rows .* - (\S+) - .*\[Transform3D:.*translation", shown
        )
    }
    every = int(a.run.horizon_s * RATE_HZ)
    moved_s = sum(motion.end_s - motion.start_s for motion in a.run.motions)
    assert rows["/world/robot/base"] == 1
    assert 0.8 * moved_s * RATE_HZ < rows["/world/robot/hand"] < 0.95 * every
    assert 1 < rows["/world/bodies/can1"] < 0.4 * every
    assert 1 < rows["/world/robot/hand/left_finger"] < 0.3 * rows["/world/robot/hand"]
    assert "/world/bodies/table" not in rows


def test_fingers_are_where_the_hand_is_opened(tmp_path: Path) -> None:
    a = assess(request_for(SOLUTION))
    assert a.run is not None
    write_recording(a, tmp_path / "run.rrd")
    times, at = column(tmp_path / "run.rrd", "/world/robot/hand/right_finger", TRANSLATION)
    openings = [a.run.at(min(time_s, a.run.horizon_s)).hand_opening for time_s in times.tolist()]
    assert np.abs(np.abs(at[:, 0, 1]) - np.array(openings) / 2).max() < 1e-6
    assert len(set(openings)) > 5


def test_curves_hold_what_straight_lines_between_their_rows_would_not(tmp_path: Path) -> None:
    a = assess(request_for(SOLUTION))
    assert a.run is not None
    assert a.scene is not None
    write_recording(a, tmp_path / "run.rrd")
    times, values = column(tmp_path / "run.rrd", "/range", "Scalars:scalars")
    every = times_of(a.run)
    assert len(times) < 0.7 * len(every)
    arm = a.scene.robot.arm
    q = np.array([a.run.at(t).configuration for t in every])
    lower, upper = np.array(arm.lower), np.array(arm.upper)
    share = 100 * (2 * q - lower - upper) / (upper - lower)
    for joint in range(6):
        assert (
            np.abs(np.interp(every, times, values[:, joint]) - share[:, joint]).max()
            < TOLERANCE + 1e-6
        )


def test_only_rows_where_a_line_bends_are_kept() -> None:
    times = np.arange(41) / 10
    values = np.stack([np.abs(times - 1.6), np.minimum(times, 2.4)], axis=1)
    assert times[bends(times, values, 0.01)].tolist() == [0, 0.8, 1.6, 2.4, 3.2, 4.0]
    assert bends(times, np.square(times)[:, None], 1e-6).all()
    assert bends(times[:1], values[:1], 0.01).all()


def column(path: Path, entity: str, name: str) -> tuple[Array, Array]:
    """Return the times [s] and the values of the rows of an entity, shape (n, ...)."""
    for chunk in RrdReader(path).stream():
        if chunk.entity_path == entity and not chunk.is_static:
            rows = cast(Any, chunk.to_record_batch())  # pyright: ignore[reportUnknownMemberType]
            return 1e-9 * np.array(rows["t"].cast("int64")), np.array(rows[name].to_pylist())
    raise AssertionError(f"no {entity} in {path}")


def test_nothing_of_this_machine_is_in_a_recording(tmp_path: Path) -> None:
    path = tmp_path / "run.rrd"
    write_recording(assess(request_for(HITS, Where(task=SOLUTION.parent / "task.toml"))), path)
    shown = subprocess.run(
        [RERUN, "rrd", "print", "-vvv", path], capture_output=True, text=True, check=True
    ).stdout
    assert "hits-base.v2" in shown
    for word in (ROOT, tmp_path, Path.home(), socket.gethostname(), "start_time"):
        assert str(word) not in shown


def test_names_say_only_themselves_in_the_summary() -> None:
    assert plain_markdown("![x](http://a) `b` <c>") == ("\\!\\[x\\](http://a) \\`b\\` \\<c\\>")
