"""A file that says which columns of a log hold what."""

import numpy as np
import pytest

from tests.unit.validate.support import path_run
from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.base.units import DEG, MM
from vrts.pipeline.refused import Refused
from vrts.validate.log.columns_file import ChosenColumns, read_columns
from vrts.validate.log.log import GivenLog, RobotLog, read_log
from vrts.validate.log.log_columns import column_of
from vrts.validate.sampling import extent_of, sampled

TIMES = np.arange(0.0, 16.5, 0.05)
NAMED = """
time = "stamp [ms]"
joints = ["axis a [rad]", "b [rad]", "c [rad]", "d [rad]", "e [rad]", "f [rad]"]
position = ["px [m]", "py [m]", "pz [m]"]
count.sign = [1, -1, 1, 1, -1, 1]
count.add_deg = [0, 90, 0, 0, 0, -30]
"""
NUMBERED = """
time = "1 [ms]"
joints = ["2 [rad]", "3 [rad]", "4 [rad]", "5 [rad]", "6 [rad]", "7 [rad]"]
position = ["8 [m]", "9 [m]", "10 [m]"]
count.sign = [1, -1, 1, 1, -1, 1]
count.add_deg = [0, 90, 0, 0, 0, -30]
"""


def log(header: bool = True) -> bytes:
    """Return the closed path as a robot logs it that counts its joints another way."""
    samples = sampled(path_run(), TIMES)
    joints = samples.joints.copy()
    joints[:, 1] = -(joints[:, 1] - 90 * DEG)
    joints[:, 4] *= -1
    joints[:, 5] += 30 * DEG
    rows = np.column_stack((1e3 * TIMES, joints, samples.positions))
    lines = ["stamp,Axis A,b,c,d,e,f,px,py,pz"] if header else []
    lines += [",".join(f"{value:.9f}" for value in row) for row in rows]
    return "\n".join(lines).encode()


def said(text: str) -> ChosenColumns:
    found = read_columns(SourceFile("columns.toml", text))
    assert isinstance(found, ChosenColumns), found
    return found


def wrong(text: str) -> list[str]:
    found = read_columns(SourceFile("columns.toml", text))
    assert not isinstance(found, ChosenColumns)
    return [d.headline for d in found]


def read(text: str, data: bytes) -> RobotLog:
    return read_log(GivenLog("log.csv", (data,), said(text)), extent_of(path_run()))


@pytest.mark.parametrize(("text", "header"), [(NAMED, True), (NUMBERED, True), (NUMBERED, False)])
def test_columns_are_those_that_the_file_names(text: str, header: bool) -> None:
    found = read(text, log(header))
    expected = sampled(path_run(), TIMES)
    assert found.joints is not None
    assert found.positions is not None
    assert np.abs(found.joints - expected.joints).max() < 1e-8
    assert np.abs(found.positions - expected.positions).max() < 1e-6 * MM
    assert np.abs(found.times - TIMES).max() < 1e-9


def test_a_name_that_no_column_has_is_told_with_the_nearest() -> None:
    with pytest.raises(Refused) as caught:
        read(NAMED.replace("stamp", "stammp"), log())
    (found,) = caught.value.diagnostics
    assert found.headline == "the log has no column `stammp`"
    assert found.help == ("did you mean `stamp`?",)
    assert isinstance(found, Diagnostic)


@pytest.mark.parametrize(
    ("old", "new", "headline"),
    [
        ('time = "stamp [ms]"', "", "the file needs `time`"),
        ("[ms]", "[h]", "`h` is no unit of `time`"),
        (', "f [rad]"', "", "`joints` names 5 columns, not 6"),
        ("sign = [1, -1", "sign = [1, 2", "a sign is 1 or -1"),
        ("position", "positoin", "unknown key `positoin` in the file"),
    ],
)
def test_what_is_wrong_in_the_file_is_told(old: str, new: str, headline: str) -> None:
    assert wrong(NAMED.replace(old, new)) == [headline]


def test_a_file_without_joints_and_position_is_no_use() -> None:
    assert wrong('time = "t"') == ["the file names no joints and no position"]


def test_names_of_rtde_and_plotjuggler_are_known() -> None:
    rtde = [column_of(0, f"actual_q_{k}") for k in range(6)]
    topic = [column_of(0, f"/joint_states/joint_{k}/position") for k in range(1, 7)]
    arm = ("shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3")
    universal = [column_of(0, f"/joint_states/{name}_joint/position") for name in arm]
    for found in (rtde, topic, universal):
        assert [(c.number, c.unit) for c in found if c is not None] == [
            (k, "rad") for k in range(6)
        ]
    for other in ("target_q_0", "actual_qd_1", "/joint_states/joint_1/velocity"):
        assert column_of(0, other) is None
    time = column_of(0, "__time")
    assert time is not None
