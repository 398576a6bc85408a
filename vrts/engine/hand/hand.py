"""The hand: strokes of the fingers, what they grasp, carry and let go, and where objects are.

Frames: F is the flange, P stands between the pads, O is an object. The hand closes and opens at
constant speed. Objects attach as they lie at the instant the opening equals their width.
"""

import math
from typing import NamedTuple, TypeAlias

from vrts.base.pose import Pose
from vrts.engine.hand import told
from vrts.engine.hand.meeting import Fingers, Lying, Met
from vrts.engine.hand.resting import Standing
from vrts.engine.memory.events import (
    Cause,
    Event,
    Grasped,
    HandCommanded,
    Landed,
    MissedOffCentre,
    Released,
    Toppled,
)
from vrts.engine.memory.log import Log
from vrts.engine.memory.records import GRAVITY, Lie, Placement, Stroke, stroke_at
from vrts.engine.motion.planner import Planner
from vrts.ir.instructions import HandAction
from vrts.robots.kinematics.kinematics import hand_pose
from vrts.robots.model import Gripper
from vrts.scene.model import Mobility, Scene

EventLog: TypeAlias = Log[Event]
GONE_M = -100.0  # [m] z of what was taken away: nothing can touch it, nothing sees it


class Closing(NamedTuple):
    """The hand closes, and what comes of it unless the arm's motion is changed before."""

    begin_s: float
    start_m: float
    cause: Cause
    end_s: float  # of the stroke, or the instant of the grasp
    body: str | None  # grasped, or missed
    X_FO: Pose | None  # of the body grasped
    tested: bool  # the program finds out by itself whether a part is in the hand


class Hand:
    """The hand's tracks, and where every movable body is."""

    def __init__(self, scene: Scene, opening_m: float) -> None:
        """Start with every body where the scene has it."""
        self.gripper: Gripper = scene.robot.gripper
        self.scene = scene
        self.opening_m = opening_m  # before the first stroke
        self.strokes: list[Stroke] = []
        self.closing: Closing | None = None
        self.held: str | None = None
        self.slips = False  # what is grasped next drops out of the hand
        self.misses = False  # what would be grasped next is not there
        self.planner: Planner  # where the arm goes: set by the machine
        self.placements: dict[str, list[Placement]] = {
            body.name: [Placement(body.name, 0.0, math.inf, Lie.RESTING, body.X_WO, body.rests_on)]
            for body in scene.bodies
            if body.mobility is Mobility.MOVABLE
        }

    def copy(self) -> "Hand":
        """Return an independent hand that shares the past."""
        other = Hand.__new__(Hand)
        other.__dict__.update(self.__dict__)
        other.strokes = self.strokes.copy()
        other.placements = {name: list(track) for name, track in self.placements.items()}
        return other

    def opening(self, time_s: float) -> float:
        """Return the opening at a time not before the last stroke [m]."""
        for stroke in reversed(self.strokes):
            if time_s >= stroke.start_s:
                return stroke_at(stroke, time_s)
        return self.opening_m

    def settle_until(self, time_s: float, events: EventLog) -> None:
        """Carry out what comes of closing, if its instant has come."""
        if self.closing is None or self.closing.end_s > time_s:
            return
        closing, self.closing = self.closing, None
        if closing.X_FO is None:
            self._report_miss(closing, events)
            return
        assert closing.body is not None
        self.held = closing.body
        last = self.placements[closing.body][-1]
        X_FW = closing.X_FO @ last.X.inverse()
        carried = self._stack_on(closing.body)
        self.place(closing.body, closing.end_s, Lie.HELD, closing.X_FO, None)
        for name, support in carried:
            X_WO = self.placements[name][-1].X
            self.place(name, closing.end_s, Lie.HELD, X_FW @ X_WO, support)
        events.append(Grasped(closing.end_s, closing.body, closing.X_FO, closing.cause))
        if self.slips:
            self.slips = False
            self._release(closing.end_s, None, events)

    @property
    def next_s(self) -> float | None:
        """When something comes of closing the hand [s]; None when it is not closing."""
        return self.closing.end_s if self.closing is not None else None

    def path_changed(self, now: float) -> None:
        """Find out anew what comes of closing: the arm goes another way from now on."""
        closing = self.closing
        if closing is None or closing.end_s <= now:
            return
        self.strokes.pop()
        self._close(closing.start_m, closing.begin_s, closing.cause, tested=closing.tested)

    def let_slip(self, time_s: float, cause: Cause | None, events: EventLog) -> None:
        """Lose what the hand holds, or else what it grasps next, although it stays closed."""
        if self.held is None:
            self.slips = True
        else:
            self._release(time_s, cause, events)

    @property
    def grasps_s(self) -> float | None:
        """When the closing hand will grasp something [s]; None: it closes on nothing."""
        closing = self.closing
        return closing.end_s if closing is not None and closing.X_FO is not None else None

    def miss(self) -> None:
        """Let what the hand is closing on, or else would grasp next, be gone by then."""
        closing = self.closing
        if closing is None or closing.X_FO is None:
            self.misses = True
            return
        assert closing.body is not None
        self.take(closing.body, closing.end_s)
        self.strokes.pop()
        self._close_on(None, closing.start_m, closing.begin_s, closing.cause, tested=closing.tested)

    def take(self, name: str, time_s: float) -> None:
        """Let a body that the hand does not hold be gone, with what stands on it."""
        for each in (name, *(other for other, _ in self._stack_on(name))):
            x, y, _ = self.placements[each][-1].X.translation
            X_WO = Pose(self.scene.body(each).X_WO.rotation, (x, y, GONE_M))
            self.place(each, time_s, Lie.RESTING, X_WO, None)

    def _flange_at(self, time_s: float) -> Pose:
        planner = self.planner
        return hand_pose(planner.arm, planner.configuration_at(time_s))

    def command(
        self,
        action: HandAction,
        time_s: float,
        cause: Cause,
        events: EventLog,
        *,
        tested: bool = False,
    ) -> None:
        """Begin an action of the hand at an instant, which is not before that of the last one.

        A motion that was joined to another begins when its path does, which may be the tick that
        is carried out but for a last digit.
        """
        if self.strokes:
            time_s = max(time_s, self.strokes[-1].start_s)
        self.settle_until(time_s, events)
        self.closing = None
        events.append(HandCommanded(time_s, action.value, cause))
        start = self.opening(time_s)
        if action is HandAction.CLOSE:
            if self.held is None:
                self._close(start, time_s, cause, tested=tested)
            return
        if self.held is not None:
            self._release(time_s, cause, events)
        self._stroke(
            time_s, start, self.gripper.opening_max if action is HandAction.OPEN else start
        )

    # --- closing ------------------------------------------------------------------------------

    def _close(self, start: float, time_s: float, cause: Cause, *, tested: bool) -> None:
        gripper, moves = self.gripper, self.planner.motion_end > time_s
        stop = time_s + (start - gripper.opening_min) / gripper.finger_speed
        fingers = Fingers(gripper, start, time_s, stop, self._flange_at, moves)
        found = fingers.first_met(self._lying_since(time_s))
        if isinstance(found, Met) and self.misses:
            self.misses = False
            self.take(found.name, found.time_s)
            found = None
        if isinstance(found, Met):
            instant, body = found
            X_FO = self._flange_at(instant).inverse() @ self.placements[body][-1].X
            self.closing = Closing(time_s, start, cause, instant, body, X_FO, tested)
            self.strokes.append(Stroke(time_s, instant, start, fingers.opening(instant)))
            return
        self._close_on(found, start, time_s, cause, tested=tested)

    def _close_on(
        self, missed: str | None, start: float, time_s: float, cause: Cause, *, tested: bool
    ) -> None:
        """Close to the end, with nothing between the pads but perhaps a body off their middle."""
        gripper = self.gripper
        stop = time_s + (start - gripper.opening_min) / gripper.finger_speed
        self.closing = Closing(time_s, start, cause, stop, missed, None, tested)
        self.strokes.append(Stroke(time_s, stop, start, gripper.opening_min))

    def _lying_since(self, time_s: float) -> list[Lying]:
        """Return what has lain still since a time, or longer."""
        return [
            Lying(name, self.scene.body(name).pieces, track[-1].X)
            for name, track in self.placements.items()
            if track[-1].start_s <= time_s and track[-1].lie in (Lie.RESTING, Lie.TOPPLED)
        ]

    def _report_miss(self, closing: Closing, events: EventLog) -> None:
        stop, cause, found = closing.end_s, closing.cause, closing.body
        if found is not None:
            events.append(MissedOffCentre(stop, found, cause))
            events.append(told.off_centre(stop, found, cause))
        elif not closing.tested:
            already = closing.start_m <= self.gripper.opening_min
            events.append(told.closed_on_nothing(stop, cause, already=already))

    # --- opening ------------------------------------------------------------------------------

    def _release(self, time_s: float, cause: Cause | None, events: EventLog) -> None:
        # the door to numpy, which is loaded when something is let go, if ever
        from vrts.engine.hand.settle import settle

        assert self.held is not None
        name, self.held = self.held, None
        X_WF = self._flange_at(time_s)
        carried = [
            track[-1]
            for track in self.placements.values()
            if track[-1].lie is Lie.HELD and track[-1].body != name
        ]
        body = self.scene.body(name)
        X_WO = X_WF @ self.placements[name][-1].X
        group = {name} | {placement.body for placement in carried}
        rest = settle(body.pieces, X_WO, body.centre_of_mass, self._supports(group))
        if rest is None:  # nothing below, not even a floor: it stays where it was let go
            events.append(Released(time_s, name, 0.0, cause))
            self.place(name, time_s, Lie.TOPPLED, X_WO, None)
            return
        events.append(Released(time_s, name, rest.height_m, cause))
        landing = time_s + math.sqrt(2.0 * rest.height_m / GRAVITY)
        lie = Lie.RESTING if rest.stands else Lie.TOPPLED
        X_OO = X_WO.inverse() @ rest.X_WO  # as seen from the body
        for member, X, support in (
            (name, X_WO, rest.support),
            *((p.body, X_WF @ p.X, p.support) for p in carried),
        ):
            if landing > time_s:
                self.place(member, time_s, Lie.FALLING, X, None)
            X_end = X_WO @ X_OO @ X_WO.inverse() @ X
            self.place(member, landing, lie, X_end, support)
        on = (rest.support, *rest.also)
        if rest.height_m > told.DROP_HEIGHT:
            events.append(told.dropped(time_s, name, rest.height_m, on, cause))
        if rest.stands:
            events.append(Landed(landing, name, rest.support, cause, rest.also))
            return
        events.append(Toppled(landing, name, rest.support, cause, rest.also))
        events.append(told.toppled(landing, name, on, cause))

    def _supports(self, without: set[str]) -> list[Standing]:
        found: list[Standing] = []
        for body in self.scene.bodies:
            if body.name in without:
                continue
            movable = body.mobility is Mobility.MOVABLE
            X_WO = self.placements[body.name][-1].X if movable else body.X_WO
            found.append(Standing(body.name, body.pieces, X_WO))
        return found

    # --- records ------------------------------------------------------------------------------

    def _stroke(self, time_s: float, start: float, end: float) -> None:
        if start == end:
            if self.strokes and self.strokes[-1].end_s > time_s:
                self.strokes.append(Stroke(time_s, time_s, start, start))
            return
        needed = abs(end - start) / self.gripper.finger_speed
        self.strokes.append(Stroke(time_s, time_s + needed, start, end))

    def place(self, name: str, time_s: float, lie: Lie, X: Pose, support: str | None) -> None:
        """Let a body be somewhere from a time on."""
        track = self.placements[name]
        track[-1] = track[-1]._replace(end_s=time_s)
        track.append(Placement(name, time_s, math.inf, lie, X, support))

    def _stack_on(self, name: str) -> list[tuple[str, str]]:
        """Return the bodies that rest on a body, directly or not, with their supports."""
        found: list[tuple[str, str]] = []
        for other, track in self.placements.items():
            last = track[-1]
            if last.lie is Lie.RESTING and last.support == name:
                found += [(other, name), *self._stack_on(other)]
        return found
