"""Limits of joints on segments of any degree, where nothing shows at the segment's ends."""

import math

import numpy as np
import pytest

from tests.support_programs import run_body
from tests.support_runs import run, with_segments
from tests.support_segments import Row, blend, sampled, segment, slowed
from vrts.check.verdict import Answer
from vrts.check.verdicts.limits import check_limits
from vrts.engine.memory.records import Segment

ARM = run().scene.robot.arm
TOP = ARM.speed[0]


def on_joint_1(row: Row, **where: float) -> Segment:
    return segment(row, *(((q,)) for q in ARM.ready[1:]), **where)


def there_and_back(most: float, length: float = 1.0) -> Row:
    """A quartic at rest at both ends that is fastest twice in between."""
    # u^2 (1 - u)^2: its speed is largest, sqrt(3) / 9, at (3 - sqrt(3)) / 6
    c = most * 9.0 / math.sqrt(3.0) * length
    return (0.0, 0.0, c / length**2, -2.0 * c / length**3, c / length**4)


@pytest.mark.parametrize(("share", "answer"), [(1.0, Answer.HOLDS), (1.0001, Answer.VIOLATED)])
def test_the_speed_inside_a_quartic_counts(share: float, answer: Answer) -> None:
    found = check_limits(with_segments(on_joint_1(there_and_back(share * TOP))))
    assert found.answer is answer
    assert found.evidence["largest_speed_share"] == round(share, 4)


def test_the_fastest_moment_of_a_motion_is_told() -> None:
    slow = on_joint_1(there_and_back(1.1 * TOP))
    fast = on_joint_1(there_and_back(1.5 * TOP, 2.0), start_s=1.0, length=2.0)
    found = check_limits(with_segments(slow, fast))
    (finding,) = found.findings
    assert finding.rule.code == "V302"
    assert finding.data["speed_deg_s"] == pytest.approx(math.degrees(1.5 * TOP), rel=1e-9)
    assert finding.moment is not None
    u = (3.0 - math.sqrt(3.0)) / 6.0
    times = [1.0 + 2.0 * u, 1.0 + 2.0 * (1.0 - u)]
    assert min(abs(finding.moment.time_s - t) for t in times) < 1e-6
    at = np.array([finding.moment.time_s - 1.0])
    assert finding.moment.configuration[0] == pytest.approx(
        float(sampled(fast.coefficients[0], at)[0]), abs=1e-9
    )


def test_slowing_down_inside_a_blend_is_judged_as_it_moves() -> None:
    full = blend(0.0, 1.2 * TOP, 0.0, 1.0)
    slowed_at_once = slowed(full, 0.8, -0.4)
    assert len(slowed_at_once) == 9
    assert check_limits(with_segments(on_joint_1(full))).answer is Answer.VIOLATED
    found = check_limits(with_segments(on_joint_1(slowed_at_once)))
    assert found.answer is Answer.HOLDS
    speeds = np.abs(sampled(slowed_at_once, np.linspace(0.0, 1.0, 100001), 1))
    assert found.evidence["largest_speed_share"] == round(float(speeds.max()) / TOP, 4)


def test_a_range_left_between_the_ends_is_found() -> None:
    upper = ARM.upper[0]
    row = blend(upper - 0.3, 1.0, -1.0, 1.0)  # reaches 0.3125 further
    found = check_limits(with_segments(on_joint_1(row)))
    (finding,) = found.findings
    assert finding.rule.code == "V430"
    assert finding.data["value_deg"] == pytest.approx(math.degrees(upper + 0.0125), abs=1e-7)
    assert finding.moment is not None
    assert finding.moment.time_s == pytest.approx(0.5, abs=1e-6)
    inside = blend(upper - 0.3125, 1.0, -1.0, 1.0)
    assert check_limits(with_segments(on_joint_1(inside))).answer is Answer.HOLDS


def test_what_no_motion_causes_is_not_judged() -> None:
    idle = on_joint_1(there_and_back(2.0 * TOP))._replace(motion=None)
    assert check_limits(with_segments(idle)).answer is Answer.HOLDS
    slow = on_joint_1(there_and_back(0.5 * TOP), start_s=1.0)
    found = check_limits(with_segments(idle, slow))
    assert found.answer is Answer.HOLDS
    assert found.evidence["largest_speed_share"] == 0.5


def test_the_speed_for_a_straight_line_is_the_one_that_was_tried() -> None:
    body = "DRIVE 2, 45, 100\nDRIVE 3, 30, 100\nDRIVE 5, 6, 100\nHERE p\nMOVES SHIFT(p BY 0,-400,0)"
    finding = next(f for f in check_limits(run_body(body)).findings if f.rule.code == "V302")
    assert finding.help == ("SPEED 31 would do, or use MOVE instead of MOVES",)
