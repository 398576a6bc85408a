"""What has to hold of every comparison: offsets that are put in come out again, nothing else."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.unit.validate.support import (
    Array,
    exact_log,
    own_csv,
    path_run,
    turning_run,
)
from vrts.base.units import DEG, MM
from vrts.validate.comparison import compare, read_and_compare
from vrts.validate.errors import along_and_across, lengths, measures
from vrts.validate.log.log import GivenLog
from vrts.validate.log.log_columns import UNITS
from vrts.validate.offsets import Wanted, rotation_vector, turned

ALL = Wanted(time=True, base=True, tool=True)
CLOCK = Wanted()


def test_the_log_of_a_run_itself_has_errors_of_rounding_only() -> None:
    """The table has 0.001 degrees and 0.01 mm."""
    found = read_and_compare(path_run(), GivenLog("own.csv", (own_csv().encode(),)), CLOCK)
    assert [d.severity.value for d in found.findings] == []
    for errors in (found.before, found.after):
        assert errors.joints is not None
        assert float(np.abs(errors.joints).max()) < 0.0006 * DEG
        assert float(np.abs(errors.path).max()) < 0.0055 * MM
    assert abs(found.offsets.time_s) < 1e-5
    late = [v for t in found.timings for v in t.late]
    assert None not in late
    assert max(abs(v) for v in late if v is not None) < 5e-4


@pytest.mark.parametrize("joints", [True, False])
@pytest.mark.parametrize("shift_s", [0.013, -0.31, 7.25, 1.7e9])
def test_a_shift_of_the_clock_is_found(shift_s: float, *, joints: bool) -> None:
    found = compare(path_run(), exact_log(path_run(), shift_s=shift_s, joints=joints), CLOCK)
    assert found.offsets.time_s == pytest.approx(-shift_s, abs=2e-6)
    assert measures(lengths(found.after)).largest < 1e-5
    notes = [d.rule.code for d in found.findings]
    assert notes == (["V888"] if abs(shift_s) > 0.5 else [])


@pytest.mark.parametrize("joints", [True, False])
def test_a_displaced_base_is_found(*, joints: bool) -> None:
    turn = np.array([0.002, -0.001, 0.03])
    base = np.array([0.012, -0.007, 0.003])

    def displaced(points: Array) -> Array:
        return points @ turned(turn).T + base

    log = exact_log(path_run(), displaced, shift_s=0.04, joints=joints)
    found = compare(path_run(), log, Wanted(time=True, base=True))
    assert found.offsets.base_m == pytest.approx(base, abs=1e-6)
    assert found.offsets.base_rad == pytest.approx(turn, abs=1e-6)
    assert measures(lengths(found.before)).rms > 0.01
    assert measures(lengths(found.after)).largest < 1e-6


def test_base_and_tool_are_told_apart_where_the_tool_turns() -> None:
    base, tool = np.array([0.004, 0.001, -0.002]), (0.003, -0.002, 0.005)
    log = exact_log(turning_run(), lambda points: points + base, tool_m=tool)
    found = compare(turning_run(), log, ALL)
    assert found.findings == ()
    assert found.offsets.tool_m == pytest.approx(tool, abs=1e-6)
    assert found.offsets.base_m == pytest.approx(base, abs=1e-6)


def test_where_the_tool_keeps_its_direction_they_are_not_and_it_is_said() -> None:
    base = np.array([0.004, 0.001, -0.002])
    log = exact_log(path_run(), lambda points: points + base)
    assert log.joints is not None
    assert log.positions is not None
    late = log.times > 3.0  # before, the arm swings from where it stood ready
    part = replace(
        log, times=log.times[late], joints=log.joints[late], positions=log.positions[late]
    )
    found = compare(path_run(), part, ALL)
    assert [d.rule.code for d in found.findings] == ["V892", "V890"]
    assert measures(lengths(found.after)).largest < 1e-5


def test_joints_alone_tell_neither_base_nor_tool() -> None:
    log = exact_log(path_run())
    bare = replace(log, positions=None)
    found = compare(path_run(), bare, ALL)
    assert [d.rule.code for d in found.findings] == ["V892"]
    assert found.after.from_joints
    assert measures(lengths(found.after)).largest < 1e-9


@given(st.tuples(*[st.floats(-0.02, 0.02)] * 3))
@settings(max_examples=examples(8), deadline=None)
def test_errors_move_with_the_log(shift: tuple[float, float, float]) -> None:
    """Without a fit, a displacement of the log is the error."""
    none = Wanted(time=False)
    plain = compare(path_run(), exact_log(path_run()), none)
    moved = compare(path_run(), exact_log(path_run(), lambda p: p + np.array(shift)), none)
    assert np.allclose(moved.after.path - plain.after.path, shift, atol=1e-12)
    assert np.array_equal(moved.after.times, plain.after.times)


@given(st.tuples(*[st.floats(-1.0, 1.0)] * 3))
@settings(max_examples=examples(50), deadline=None)
def test_a_rotation_vector_comes_back(vector: tuple[float, float, float]) -> None:
    assert rotation_vector(turned(np.array(vector))) == pytest.approx(vector, abs=1e-9)


def test_along_is_ahead_and_beside_is_not() -> None:
    """An arm that is 10 ms ahead on a line has an error along the path alone."""
    found = compare(path_run(), exact_log(path_run(), shift_s=-0.01), Wanted(time=False))
    along, across = along_and_across(path_run(), found.after)
    middle = (found.after.times > 8.0) & (found.after.times < 9.0)  # on a line at 100 mm/s
    assert along[middle] == pytest.approx(0.001, abs=1e-5)
    assert across[middle] == pytest.approx(0.0, abs=1e-5)


def test_lateness_is_that_of_each_motion() -> None:
    """Joints that stretch over time are later and later."""
    run = path_run()
    log = exact_log(run)
    slow = replace(log, times=log.times * 1.01, positions=None)
    found = compare(run, slow, Wanted(time=False))
    for t in found.timings:
        middle = 0.5 * (t.start_s + t.end_s)
        assert t.late[1] is not None
        assert t.late[1] == pytest.approx(0.01 * middle, abs=0.002)


def test_units_are_those_of_the_house() -> None:
    assert {unit for units in UNITS.values() for unit in units} == {
        *("s", "ms", "us", "min", "deg", "rad", "mm", "m", "cm", "in"),
    }
