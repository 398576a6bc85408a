"""How far an object is from the relation that a task wants it in, at the end."""

from collections.abc import Mapping
from fractions import Fraction
from math import pi
from typing import NamedTuple

from vrts.base.pose import Pose, Vector, multiply, rotation_angle
from vrts.check.goals.placed import Errors
from vrts.check.rounding import exact_deg, exact_mm
from vrts.check.task.goals import Relation, Stands
from vrts.check.task.score import share_of
from vrts.geometry.support import bounds
from vrts.scene.model import Body
from vrts.scene.things.symmetry import symmetries_of

FARTHEST = 1e4  # [m] farther than this nothing is; the error of what does not stand on another


class Lying(NamedTuple):
    """An object at the end of a run."""

    body: Body
    X_WO: Pose
    supports: tuple[str, ...]  # all that it rests on


def missing(relation: Relation, lying: Mapping[str, Lying]) -> Errors:
    """Return by how much a relation is missed: 0 where it holds."""
    this = lying[relation.body]
    x, y, _ = _middle(this)
    if relation.stands is Stands.INSIDE:
        box = bounds(this.body.pieces, this.X_WO)
        low = max(a - b for a, b in zip(relation.lower, box.lower, strict=True))
        high = max(b - a for a, b in zip(relation.upper, box.upper, strict=True))
        return _by(max(low, high))
    other = lying[relation.other]
    u, v, _ = _middle(other)
    match relation.stands:
        case Stands.LEFT:
            return _by(relation.distance - (y - v))
        case Stands.RIGHT:
            return _by(relation.distance - (v - y))
        case Stands.FARTHER:
            return _by(relation.distance - (x - u))
        case Stands.NEARER:
            return _by(relation.distance - (u - x))
        case Stands.ON:
            if relation.other not in this.supports:
                return _by(FARTHEST)
            away = 0.0 if relation.tolerance is None else max(abs(x - u), abs(y - v))
            return _by(away)
        case Stands.ALIGNED:
            off = abs(y - v) if relation.along == "x" else abs(x - u)
            return Errors(exact_mm(off), exact_deg(_turned(this, other)))


def share(relation: Relation, found: Errors, zero_at: Fraction) -> Fraction:
    """Return the share of a relation: 1 where it holds, falling from there if the task says so."""
    if relation.tolerance is None:
        return Fraction(found.position_mm == 0)
    near = share_of(found.position_mm, exact_mm(relation.tolerance), zero_at)
    if relation.stands is not Stands.ALIGNED:
        return near
    turned = share_of(found.orientation_deg, exact_deg(relation.turn_tolerance), zero_at)
    return min(near, turned)


def _by(amount: float) -> Errors:
    return Errors(max(Fraction(0), exact_mm(amount)), Fraction(0))


def _middle(lying: Lying) -> Vector:
    """Return the middle of what an object covers along the axes of W."""
    box = bounds(lying.body.pieces, lying.X_WO)
    x, y, z = (0.5 * (a + b) for a, b in zip(box.lower, box.upper, strict=True))
    return (x, y, z)


def _turned(this: Lying, other: Lying) -> float:
    """Return how far two objects are from being turned alike [rad]; a round one always is."""
    mine, theirs = symmetries_of(this.body), symmetries_of(other.body)
    if mine.axis is not None or theirs.axis is not None:
        return 0.0
    return min(
        (
            rotation_angle(
                multiply(this.X_WO.rotation, a.rotation), multiply(other.X_WO.rotation, b.rotation)
            )
            for a in mine.turns
            for b in theirs.turns
        ),
        default=pi,
    )
