"""Recordings hold the run as it was: what the viewer is sent, and that it opens."""

import math
import re
import socket
import subprocess
import sys
from pathlib import Path

import numpy as np

from vrts.base.pose import rotation_about
from vrts.pipeline.assess import assess
from vrts.pipeline.settings import setting_for
from vrts.report.recording import RATE_HZ, write_recording
from vrts.report.recording.lanes import states
from vrts.report.recording.motion import quaternions
from vrts.report.recording.names import plain_markdown

ROOT = Path(__file__).parent.parent.parent.parent
SOLUTION = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"
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
    setting = setting_for(HITS, scene=None, task=SOLUTION.parent)
    write_recording(assess(HITS, setting=setting), path)
    shown = subprocess.run(
        [RERUN, "rrd", "print", "-vvv", path], capture_output=True, text=True, check=True
    ).stdout
    assert "can1 touches base1" in shown
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
    write_recording(assess(SOLUTION), path)
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
    a = assess(SOLUTION)
    assert a.run is not None
    write_recording(a, path)
    shown = subprocess.run(
        [RERUN, "rrd", "print", path], capture_output=True, text=True, check=True
    ).stdout
    rows = {
        entity: int(count)
        for count, entity in re.findall(r"with (\d+) rows .* - (\S+) - .*quaternion", shown)
    }
    every = int(a.run.horizon_s * RATE_HZ)
    moved_s = sum(motion.end_s - motion.start_s for motion in a.run.motions)
    assert rows["/world/robot/base"] == 1
    assert 0.8 * moved_s * RATE_HZ < rows["/world/robot/hand"] < 0.95 * every
    assert rows["/world/robot/hand"] < rows["/world/robot/left_finger"] < every
    assert 1 < rows["/world/bodies/can1"] < 0.4 * every
    assert "/world/bodies/table" not in rows


def test_nothing_of_this_machine_is_in_a_recording(tmp_path: Path) -> None:
    path = tmp_path / "run.rrd"
    write_recording(assess(HITS, task=SOLUTION.parent / "task.toml"), path)
    shown = subprocess.run(
        [RERUN, "rrd", "print", "-vvv", path], capture_output=True, text=True, check=True
    ).stdout
    assert "hits-base.v2" in shown
    for word in (ROOT, tmp_path, Path.home(), socket.gethostname(), "start_time"):
        assert str(word) not in shown


def test_names_say_only_themselves_in_the_summary() -> None:
    assert plain_markdown("![x](http://a) `b` <c>") == ("\\!\\[x\\](http://a) \\`b\\` \\<c\\>")
