"""A rounded corner: its velocities are those of its poses."""

import math

import numpy as np
import pytest

from vrts.base.oat import pose_from_components
from vrts.base.pose import multiply, transpose
from vrts.controllers.model import LineTurn
from vrts.engine.motion.lines.path import Course, line, rounding

START = pose_from_components(900, -300, 100, 90, 90, 0)
CORNER = pose_from_components(900, 0, 0, 60, 70, 20)
END = pose_from_components(700, 200, 50, 100, 80, -50)
FIRST = {turn: line(START, CORNER, turn) for turn in LineTurn}
SECOND = {turn: line(CORNER, END, turn) for turn in LineTurn}
STEP = 1e-6  # [s]


def course(t: float, turn: LineTurn = LineTurn.TWO_TURNS) -> Course:
    """Slow down on the first line while picking up speed on the second."""
    before = FIRST[turn].course(1.0 - 0.3 * (1.0 - t) ** 2, 0.6 * (1.0 - t))
    after = SECOND[turn].course(0.2 * t * t, 0.4 * t)
    return rounding(CORNER)(before, after)


@pytest.mark.parametrize("turn", LineTurn)
@pytest.mark.parametrize("t", [0.1, 0.4, 0.5, 0.8])
def test_velocities_are_the_changes_of_the_poses(t: float, turn: LineTurn) -> None:
    here, later = course(t, turn), course(t + STEP, turn)
    moved = np.subtract(later.X_BT.translation, here.X_BT.translation) / STEP
    assert moved == pytest.approx(here.v, abs=1e-4)
    turned = multiply(later.X_BT.rotation, transpose(here.X_BT.rotation))
    spin = np.array([turned[7] - turned[5], turned[2] - turned[6], turned[3] - turned[1]]) / (
        2 * STEP
    )
    assert spin == pytest.approx(here.w, abs=1e-4)
    assert math.dist((0, 0, 0), here.w) > 0.05


def test_the_ends_are_on_the_lines() -> None:
    first, second = FIRST[LineTurn.TWO_TURNS], SECOND[LineTurn.TWO_TURNS]
    assert course(1.0).X_BT.translation == pytest.approx(second.pose(0.2).translation)
    assert course(0.0).X_BT.translation == pytest.approx(first.pose(0.7).translation)
    assert course(1.0).X_BT.rotation == pytest.approx(second.pose(0.2).rotation)
