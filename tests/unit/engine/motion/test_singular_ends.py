"""Lines that end where the wrist is singular end at rest all the same."""

import pytest

from tests.support_engine import runs


@pytest.mark.parametrize("between", ["", "BREAK\n", "BREAK\nSPEED 20\n"])
def test_a_line_back_to_a_singular_pose_ends_at_rest(between: str) -> None:
    run = runs(f"SET p = HERE\nDRIVE 3, -20, 40\n{between}MOVES p")
    last = run.motions[-1]
    speeds = run.at(last.end_s - 1e-7).velocity
    assert speeds == pytest.approx((0.0,) * 6, abs=1e-4)
