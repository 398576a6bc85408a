"""The convex pieces that take part in a check: of the robot, and of every body wherever it is."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose, Vector, rotate, translation
from vrts.check.collision.pairs.arm_state import RunRecord
from vrts.engine.memory.records import Lie, Placement
from vrts.geometry.shapes import Piece
from vrts.geometry.solids import Solid
from vrts.robots.model import Robot
from vrts.scene.model import Body, Mobility

Array: TypeAlias = npt.NDArray[np.float64]

PALM = "palm"  # the gripper without its fingers
HAND = 6  # frame of flange and gripper
SUPPORT_LOWERED = 1e-3  # [m] a support is tested this much lower against what stands on it
LOWERED = translation(0.0, 0.0, -SUPPORT_LOWERED)


class Stay(NamedTuple):
    """A body where one placement has it."""

    body: str
    start_s: float
    end_s: float
    lie: Lie
    before: str | None  # what it stood on before
    after: str | None  # what it will stand on after
    members: tuple[int, ...]  # solids
    lowered: tuple[int, ...]  # the same, lowered by 1 mm; of what can be a support

    @property
    def still(self) -> bool:
        """Whether it does not move."""
        return self.lie in (Lie.RESTING, Lie.TOPPLED)

    def parted_from(self, other: "Stay") -> bool:
        """Return whether it stood on another body before, or will stand on it."""
        return other.still and other.body in (self.before, self.after)


class RobotSolids(NamedTuple):
    """Solids of the robot."""

    links: tuple[tuple[str, int, tuple[int, ...]], ...]  # name, joint, solids
    palm: tuple[int, ...]
    fingers: tuple[tuple[int, ...], ...]


@dataclass(slots=True)
class Cast:
    """Collects solids."""

    start_s: float
    end_s: float
    X_LF: Pose  # the flange in L_6
    members: list[Solid] = field(default_factory=list[Solid])

    def add(
        self,
        pieces: Iterable[Piece],
        frame: int,
        X_LO: Pose,
        part: str,
        slide: Vector = (0.0, 0.0, 0.0),
        falls_from_s: float | None = None,
    ) -> tuple[int, ...]:
        """Add the pieces of a body and return their indices."""
        first = len(self.members)
        self.members += [
            Solid(piece.shape, frame, X_LO @ piece.X_OP, part, slide, falls_from_s)
            for piece in pieces
        ]
        return tuple(range(first, len(self.members)))


def robot_solids(cast: Cast, robot: Robot) -> RobotSolids:
    """Add the pieces of the robot and return which they are."""
    links = tuple(
        (link.name, link.joint, cast.add(link.pieces, link.joint, translation(0, 0, 0), link.name))
        for link in robot.arm.links
    )
    palm = cast.add(robot.gripper.body, HAND, cast.X_LF, PALM)
    fingers = tuple(
        cast.add(
            finger.pieces,
            HAND,
            cast.X_LF,
            finger.name,
            rotate(cast.X_LF.rotation, (0.0, 0.5 * finger.side, 0.0)),
        )
        for finger in robot.gripper.fingers
    )
    return RobotSolids(links, palm, fingers)


def stays_of(
    cast: Cast, body: Body, placements: Sequence[Placement], supports: frozenset[str]
) -> list[Stay]:
    """Return where a body is over time, each time with solids of its own."""
    found: list[Stay] = []
    for number, placement in enumerate(placements):
        start_s = max(placement.start_s, cast.start_s)
        end_s = min(placement.end_s, cast.end_s)
        if end_s <= start_s:
            continue
        held = placement.lie is Lie.HELD
        falling = placement.lie is Lie.FALLING
        X_LO = cast.X_LF @ placement.X if held else placement.X
        members = cast.add(
            body.pieces,
            HAND if held else 0,
            X_LO,
            body.name,
            falls_from_s=placement.start_s if falling else None,
        )
        lowered: tuple[int, ...] = ()
        if body.name in supports and not held and not falling:
            lowered = cast.add(body.pieces, 0, LOWERED @ X_LO, body.name)
        before = body.rests_on if number == 0 else placements[number - 1].support
        after = next(
            (p.support for p in placements[number + 1 :] if p.lie is not Lie.FALLING), None
        )
        found.append(
            Stay(body.name, start_s, end_s, placement.lie, before, after, members, lowered)
        )
    return found


def placements_of(body: Body, run: RunRecord) -> Sequence[Placement]:
    """Return where a body is in a run, in time order; for ever where it stands if fixed."""
    known = run.placements.get(body.name, ()) if body.mobility is Mobility.MOVABLE else ()
    return known or (Placement(body.name, -np.inf, np.inf, Lie.RESTING, body.X_WO, None),)
