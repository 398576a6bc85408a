"""When fingers come free of what was let go: at one of the instants at which that is looked for."""

import math
from collections.abc import Iterator
from typing import TypeAlias

import numpy as np

from vrts.base.pose import Pose
from vrts.check.collision.pairs.arm_state import Asked, Prober
from vrts.check.collision.pairs.cast import Cast, robot_solids
from vrts.check.collision.pairs.grips import FINE, SEPARATED
from vrts.check.collision.pairs.pairs import FAR
from vrts.check.curves.timeline_arrays import curves
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.records import INSTANT, Segment, pose_of
from vrts.geometry.proposing.proposer import Proposer
from vrts.geometry.proving.prover import Prover
from vrts.geometry.solids import solids
from vrts.prove.certify.memory import LettingGo, place_at
from vrts.prove.certify.stretches import configuration_at
from vrts.robots.kinematics.kinematics import hand_pose
from vrts.robots.model import flange_in_hand
from vrts.scene.model import Scene

MOST = 20_000  # distances that are remembered

_Asked: TypeAlias = tuple[str, Pose, tuple[float, ...], float]


class Parting:
    """Looks when fingers come free."""

    def __init__(self, scene: Scene, proposer: Proposer) -> None:
        """Know nothing."""
        self._scene = scene
        self._proposer = proposer
        self._known: dict[_Asked, tuple[float, ...]] = {}

    def until(self, machine: Machine, one: LettingGo, from_s: float, to_s: float) -> LettingGo:
        """Return a finger with the time at which it comes free, if that is between two times."""
        if one.until_s <= from_s:
            return one
        for time_s in _looks(machine, one.since_s, from_s, min(to_s, one.until_s)):
            if self._gap(machine, one, time_s) > SEPARATED:
                return one._replace(until_s=time_s)
        return one

    def _gap(self, machine: Machine, one: LettingGo, time_s: float) -> float:
        """Return how far a finger is from a body at a time [m], or more than it may be."""
        hand = machine.system.hand
        track = hand.placements[one.body]
        placement = track[place_at(track, time_s)]
        q = configuration_at(machine, time_s)
        X_WF = hand_pose(self._scene.robot.arm, q)  # type: ignore[arg-type]
        asked = (one.body, pose_of(placement, time_s, X_WF), q, hand.opening(time_s))
        known = self._known.get(asked)
        if known is None:
            if len(self._known) >= MOST:
                self._known.clear()
            known = self._known[asked] = self._measured(*asked)
        return known[one.finger]

    def _measured(
        self, body: str, X_WO: Pose, q: tuple[float, ...], opening: float
    ) -> tuple[float, ...]:
        """Return how far every finger is from a body [m]."""
        scene, arm = self._scene, self._scene.robot.arm
        cast = Cast(-np.inf, np.inf, flange_in_hand(arm))
        fingers = robot_solids(cast, scene.robot).fingers
        members = cast.add(scene.body(body).pieces, 0, X_WO, body)
        rows = tuple([(value,) for value in (*q, opening)])
        motion = curves([Segment(0.0, 1.0, rows, None)])
        arrays = solids(cast.members)
        prober = Prober(arm, motion, arrays, Prover(arrays, self._proposer))
        stays = [(members, -np.inf, np.inf)]
        gaps = prober.gaps([Asked(finger, stays, np.zeros(1)) for finger in fingers], FAR)
        return tuple([float(gap.lower[0]) for gap in gaps])


def _looks(machine: Machine, since_s: float, from_s: float, to_s: float) -> Iterator[float]:
    """Yield the instants at which it is looked for, for as long as something moves."""
    k = max(math.ceil((from_s - since_s) / FINE - INSTANT), 0)
    still_s = _still_from(machine)
    while (time_s := since_s + FINE * k) <= to_s:
        yield time_s
        if time_s >= still_s:
            return
        k += 1


def _still_from(machine: Machine) -> float:
    """Return the time from which on nothing moves, as far as it is known."""
    planner, hand = machine.system.planner, machine.system.hand
    pieces = [planner.scale.time(piece.end_s) for piece in planner.given.pieces[-1:]]
    strokes = [stroke.end_s for stroke in hand.strokes[-1:]]
    lies = [track[-1].start_s for track in hand.placements.values()]
    return max([planner.motion_end, *pieces, *strokes, *lies])
