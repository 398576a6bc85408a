"""What a session shows of its machine: frames and states, without a `Run` and its cost."""

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import Ending, Placement
from vrts.engine.programs.cycles import place
from vrts.live.session.channel.rows import Placed
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.live.session.views import frame
from vrts.live.session.views.frame import PoseFrame, output_bits
from vrts.monitor.desk import ALONE
from vrts.robots.kinematics.kinematics import forward

_RESUMABLE = (Ending.PAUSED, Ending.ABORTED, Ending.STEPPED, Ending.ERROR, Ending.LIMIT)


def pose_frame(growing: GrowingRun, session: int, sequence: int) -> PoseFrame:
    """Return the frame of this instant."""
    system = growing.machine.system
    flags = (
        (frame.RUNNING if runs(growing) else 0)
        | (frame.MOVING if growing.moving else 0)
        | (frame.STOPPING if growing.braking else 0)
        | (frame.HOLDING if system.hand.held is not None else 0)
    )
    return PoseFrame(
        session,
        sequence,
        growing.time_s,
        growing.configuration,
        growing.opening,
        output_bits(system.signals.on),
        flags,
    )


def runs(growing: GrowingRun) -> bool:
    """Return whether a robot program executes, other than a single instruction."""
    robot = growing.machine.robot
    return growing.executing and robot.program != ALONE


def mode(growing: GrowingRun, *, jogging: bool) -> str:
    """Return what the session is doing, in one word."""
    robot = growing.machine.robot
    if growing.braking:
        return "braking"
    if jogging:
        return "jogging"
    if runs(growing):
        sleeps = robot.wake > growing.time_s + growing.machine.tick
        return "waiting" if sleeps and not growing.moving else "running"
    if growing.moving or growing.executing:
        return "moving"
    if robot.frames and robot.program != ALONE and robot.ending in _RESUMABLE:
        return "stopped"
    return "idle"


def location(growing: GrowingRun) -> tuple[float, ...]:
    """Return X Y Z [mm] and O A T [degrees] of the tool, as WHERE shows them."""
    planner = growing.machine.system.planner
    X_VT = planner.base @ forward(planner.arm, growing.configuration) @ planner.tool
    return tuple(round(number, 4) + 0.0 for number in components(X_VT))


def tool(growing: GrowingRun) -> tuple[float, ...]:
    """Return the pose of the tool in force, in the flange frame; lengths in m."""
    return _numbers(growing.machine.system.planner.tool)


def step_under_way(growing: GrowingRun) -> Cause | None:
    """Return the step of the motion under way, else the one that a program is at."""
    machine = growing.machine
    planner, robot = machine.system.planner, machine.robot
    path_s = planner.scale.path(growing.time_s)
    for motion in reversed(planner.given.motions):
        if motion.start_s <= path_s:
            if path_s < motion.end_s:
                return motion.cause
            break
    if robot.finishing and robot.trace.instructions:  # the last step is done, the arm still moves
        return machine.system.programs.causes[robot.trace.instructions[-1]]
    return place(robot)


def placed(placement: Placement) -> Placed:
    """Return a placement as clients take it."""
    return Placed(
        placement.body,
        placement.start_s,
        placement.lie.value,
        _numbers(placement.X),
        placement.support,
    )


class Placements:
    """Tells what has changed since it was asked last."""

    def __init__(self, growing: GrowingRun) -> None:
        """Begin with what there is now told."""
        self._growing = growing
        self._told: dict[str, Placement] = {}
        self.news()

    @property
    def now(self) -> tuple[Placed, ...]:
        """How every body lies; one that falls has the row of its landing too."""
        found: list[Placed] = []
        for track in self._growing.machine.system.hand.placements.values():
            first = 0
            for number, placement in enumerate(track):
                if placement.start_s <= self._growing.time_s:
                    first = number
            found += map(placed, track[first:])
        return tuple(found)

    def news(self) -> tuple[Placed, ...]:
        """Return the rows that are new."""
        found: list[Placed] = []
        for name, track in self._growing.machine.system.hand.placements.items():
            told = self._told.get(name)
            fresh: list[Placement] = []
            for placement in reversed(track):
                if told is not None and _same(placement, told):
                    break
                fresh.append(placement)
            found += map(placed, reversed(fresh))
            self._told[name] = track[-1]
        return tuple(found)


def _numbers(X: Pose) -> tuple[float, ...]:
    """Return a pose as clients take it: the rotation row by row, then the translation."""
    return tuple(round(number, 9) + 0.0 for number in (*X.rotation, *X.translation))


def _same(a: Placement, b: Placement) -> bool:
    return a.start_s == b.start_s and a.lie is b.lie
