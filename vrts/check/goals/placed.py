"""How well an object lies at its goal: the turns that its shape has count as none."""

from collections.abc import Iterator
from fractions import Fraction
from math import acos
from typing import NamedTuple

from vrts.base.pose import Pose, distance, dot, rotate, rotation_angle
from vrts.check.rounding import exact_deg, exact_mm
from vrts.check.task.goals import Goal, Looks
from vrts.check.task.score import share_of
from vrts.scene.model import Body
from vrts.scene.things.symmetry import NONE, Symmetries, symmetries_of


class Errors(NamedTuple):
    """How far an object is from where it should be."""

    position_mm: Fraction
    orientation_deg: Fraction


def errors_at(
    body: Body, looks: Looks, X_WO: Pose, X_WG: Pose, goal: Goal, zero_at: Fraction
) -> tuple[Fraction, Errors]:
    """Return the share of a place, and the errors that give it: the best over all symmetries.

    Where several give as much, the one with the least turn counts, then the one least far away.
    """
    rated = [
        (share(found, goal, zero_at), -found.orientation_deg, -found.position_mm)
        for found in errors(counted(body, looks), X_WO, X_WG)
    ]
    best, turn, away = max(rated)
    return best, Errors(-away, -turn)


def share(found: Errors, goal: Goal, zero_at: Fraction) -> Fraction:
    """Return the share of a goal that an object with some errors gets."""
    return min(
        share_of(found.position_mm, exact_mm(goal.position_tolerance), zero_at),
        share_of(found.orientation_deg, exact_deg(goal.orientation_tolerance), zero_at),
    )


def counted(body: Body, looks: Looks) -> Symmetries:
    """Return the symmetries of a body that a goal lets count."""
    match looks:
        case Looks.NONE:
            return NONE
        case Looks.UPRIGHT:
            return symmetries_of(body).upright()
        case Looks.SHAPE:
            return symmetries_of(body)


def errors(symmetries: Symmetries, X_WO: Pose, X_WG: Pose) -> Iterator[Errors]:
    """Yield the errors of a pose for every turn after which the body looks the same."""
    for turn in symmetries.turns:
        X_WT = X_WO if turn is symmetries.turns[0] else X_WO @ turn
        is_there, to_be = X_WT.apply(symmetries.foot), X_WG.apply(symmetries.foot)
        yield Errors(exact_mm(distance(is_there, to_be)), exact_deg(_angle(symmetries, X_WT, X_WG)))


def _angle(symmetries: Symmetries, X_WO: Pose, X_WG: Pose) -> float:
    """Return the angle between two orientations [rad]; turning about an axis is free."""
    if symmetries.axis is None:
        return rotation_angle(X_WO.rotation, X_WG.rotation)
    is_axis = rotate(X_WO.rotation, symmetries.axis)
    to_be = rotate(X_WG.rotation, symmetries.axis)
    return acos(max(-1.0, min(1.0, dot(is_axis, to_be))))
