"""Where the arm goes: motions begun, joined and given up, and the one that waits its turn.

Frames: VAL's world is the robot's base frame displaced by BASE, so a location X of a program is
reached by the tool at X_BT = X_VB^-1 X, with X_VB the displacement of the robot. The motions given
are kept in path time; `scale` maps it to run time.
"""

import math

from vrts.base.pose import IDENTITY, Pose
from vrts.controllers.model import ControllerModel, NoLength, Settling
from vrts.engine.faults import SINGULAR_JUMP, RuntimeFault
from vrts.engine.memory.events import Cause
from vrts.engine.memory.facts import Aim, Facts
from vrts.engine.memory.records import INSTANT, Motion
from vrts.engine.motion.advice import Advice
from vrts.engine.motion.corner import Leg
from vrts.engine.motion.given import Given
from vrts.engine.motion.lines.faults import advise
from vrts.engine.motion.pending import Pending, joined
from vrts.engine.motion.plan import Intent, Planned, from_rest
from vrts.engine.motion.profile import TICK_TOLERANCE
from vrts.engine.motion.remarks import Overspeed, Remark, Told
from vrts.engine.motion.requests import Stance, with_request
from vrts.engine.motion.settings import InForce, Settings
from vrts.engine.motion.time_scale import TimeScale
from vrts.ir.instructions import BranchRequest
from vrts.robots.kinematics.branch import INITIAL_BRANCH, branch_of
from vrts.robots.kinematics.choice import NOTHING_REQUESTED
from vrts.robots.kinematics.kinematics import forward
from vrts.robots.model import Arm, ArmBranch, Configuration


class Planner:
    """Where the arm will be when all motions given so far are done, and the settings in force."""

    def __init__(
        self,
        arm: Arm,
        configuration: Configuration,
        X_FT: Pose,
        rate: float,
        model: ControllerModel,
    ) -> None:
        """Start at rest."""
        self.arm = arm
        self.model = model
        self.configuration = configuration  # at the end of the last motion
        self.branch = branch_of(arm, configuration, INITIAL_BRANCH, model.branches)
        self.request = NOTHING_REQUESTED
        self.tool = X_FT  # X_FT
        self.base: Pose = IDENTITY  # X_VB
        self.settings = InForce()
        self.tool_at_dest: Pose = forward(arm, configuration) @ X_FT  # X_BT at the destination
        self.dest: Configuration = configuration
        self.given = Given(configuration)
        self.settling_s = 0.0  # after the last motion
        self.hold_until = 0.0  # end of a DELAY, in run time
        self.remarks: dict[int, tuple[Told, ...]] = {}  # by motion
        self.leg: Leg | None = None  # None: nothing can be joined to the last motion
        self.pending: Pending | None = None
        self.advice = Advice(arm)
        self.overdue = False  # a motion has begun before its instruction could see to it
        self.scale = TimeScale(rate)
        self.ghost: tuple[Configuration, ArmBranch] | None = None  # in a dry run: where it would be
        self.braking_until = 0.0  # run time at which a stop under way is complete
        self.facts: Facts | None = None  # where changes are noted

    def copy(self) -> "Planner":
        """Return an independent planner that shares the past."""
        other = Planner.__new__(Planner)
        other.__dict__.update(self.__dict__)
        other.given = self.given.copy()
        other.remarks = self.remarks.copy()
        other.settings = self.settings.copy()
        other.advice = self.advice.copy()
        other.scale = self.scale.copy()
        return other

    # --- what is asked for ------------------------------------------------------------------------

    def ask(self, branch: BranchRequest) -> None:
        """Remember a requested branch until a joint-interpolated motion carries it out."""
        self.request = with_request(self.request, branch)
        self.tell()

    def set_tool(self, X_FT: Pose) -> None:
        """Change the tool; the destination becomes where the new tool is."""
        self.tool = X_FT
        self.tool_at_dest = forward(self.arm, self.dest) @ X_FT
        self.tell()

    def take_settings(self, *, but_speed: bool = False) -> Settings:
        """Return the settings of the motion now given; those for one motion are used up."""
        before = self.settings.next
        found = self.settings.take(but_speed=but_speed)
        if before:
            self.tell_settings()
        return found

    # --- locations ----------------------------------------------------------------------------

    def pose_of(self, q: Configuration) -> Pose:
        """Return the tool's location as a program sees it."""
        return self.base @ forward(self.arm, q) @ self.tool

    @property
    def destination(self) -> Pose:
        """DEST: where the last motion goes, as a program sees it."""
        return self.base @ self.tool_at_dest

    @property
    def origin(self) -> tuple[Configuration, ArmBranch]:
        """Where the next motion starts, and on which arm branch; in a dry run where it would."""
        return self.ghost if self.ghost is not None else (self.configuration, self.branch)

    @property
    def stance(self) -> Stance:
        """From where the next motion is asked for."""
        q, branch = self.origin
        return Stance(self.arm, q, branch, self.request, self.base, self.tool, self.model)

    def end_dry_run(self) -> None:
        """Go on from where the arm really is."""
        self.ghost = None

    # --- times --------------------------------------------------------------------------------

    @property
    def motion_end(self) -> float:
        """Run time at which the path of the last motion ends [s]."""
        end = self.scale.time(self.given.end_s)
        return max(end, self.hold_until)

    @property
    def settled_at(self) -> float:
        """Run time at which the arm counts as standing still [s]."""
        return max(self.scale.time(self.given.end_s) + self.settling_s, self.hold_until)

    @property
    def free_at(self) -> float:
        """Run time at which whatever comes after the motion under way may begin [s]."""
        waits = self.model.stops.settling is Settling.EVERY_STOP
        return self.settled_at if waits else self.motion_end

    def under_way(self, now: float) -> bool:
        """Return whether a motion or a DELAY lasts beyond a run time."""
        return self.motion_end > now + INSTANT

    def configuration_at(self, time_s: float) -> Configuration:
        """Return the joints at a run time, on the motions given so far."""
        return self.given.at(self.scale.path(time_s))

    # --- the timeline -------------------------------------------------------------------------

    def begin(
        self, intent: Intent, time_s: float, target: Pose | None, cause: Cause, *, dry: bool = False
    ) -> RuntimeFault | None:
        """Put a motion on the timeline that starts from rest; return what ends it early.

        Args:
            intent: The motion.
            time_s: Run time at which it starts.
            target: X_VT that DEST gives from now on; None: where the motion ends.
            cause: The instruction.
            dry: The arm stands still; everything else is as if it moved.
        """
        planned = from_rest(self.arm, self.tool, intent)
        start = self.given.not_before_the_end(self.scale.path(time_s))
        pieces = [] if dry else planned.pieces
        tick = self.arm.tick
        end = start + (pieces[-1][1] if pieces else 0.0)
        if self.scale.plain:
            end = max(round(end / tick) * tick, start)  # which may be off by a last digit
        last = pieces[-1][1] if pieces else 0.0
        goal = self.configuration if dry else planned.goal
        self.ghost = (planned.goal, planned.branch) if dry else None
        self.given.add(
            self._motion(intent, start, end, goal, planned.deviation_m, cause),
            [(start + a, end if b == last else start + b, rows) for a, b, rows in pieces],
        )
        if planned.fault is not None:
            self.given.change_last(short=True)
        if not dry:
            advice, rate = self.advice, self.scale.rate
            whole = planned.fault is None
            again = advice.whole(self.tool) if whole else advice.as_far_as_it_goes(self.tool)
            fast = advice.on_overspeed(intent, pieces, rate, (again,))
            if fast is not None and not whole:
                fast = fast._replace(stopped=True)
            self._remark(fast, planned.remarks)
        if planned.fault is not None and planned.fault.rule == SINGULAR_JUMP:
            past = self.advice.past(intent, planned.fault, self.scale.rate, self.tool)
            advise(planned.fault, past)
        self.configuration = goal
        self.dest = planned.goal
        self.branch = self.branch if dry else planned.branch
        reached = forward(self.arm, planned.goal) @ self.tool
        early = target is None or planned.fault is not None
        self.tool_at_dest = reached if early else self.base.inverse() @ target  # type: ignore[operator]
        no_time = self.model.pace.no_length is NoLength.NO_TIME
        self.given.stayed = goal if no_time and intent.takes_no_time else None
        still = dry or intent.takes_no_time
        if still and self.model.stops.settling is Settling.EVERY_STOP:
            self._stay(end)
        else:
            self._end(end, intent.settings)
        self.leg = self._leg(planned, intent, start) if pieces and planned.fault is None else None
        self._carry_out_request(intent)
        self.tell()
        return planned.fault

    def join(self, intent: Intent, now: float, target: Pose | None, cause: Cause) -> bool:
        """Join a motion to the one under way with a rounded corner, if there is time for it.

        The program goes on at `pending.start_s`; until then `take_back` undoes this.
        """
        leg = self.leg
        if leg is None or self.pending is not None or self.braking_until > now:
            return False
        found = joined(leg, intent, self.given, self.arm, self.tool, self.scale.path(now))
        if found is None:
            return False
        start, corner = found.start_s, found.corner
        replaced = self.given.cut(start)
        self.given.change_last(end_s=start, blended=True)
        end = corner.pieces[-1][1]
        motion = self._motion(intent, start, end, corner.goal, corner.deviation_m, cause)
        self.given.add(motion, corner.pieces)
        plannings = (found.slower, self.advice.whole(self.tool))
        fast = self.advice.on_overspeed(intent, corner.pieces, self.scale.rate, plannings)
        self._remark(fast, corner.remarks)
        self.pending = Pending(start, corner, target, intent, replaced)
        return True

    def commit(self) -> None:
        """Begin the motion that waited its turn: it cannot be taken back any more."""
        pending = self.pending
        assert pending is not None
        self.pending, corner = None, pending.corner
        self.configuration = self.dest = corner.goal
        self.branch = corner.branch
        reached = forward(self.arm, corner.goal) @ self.tool
        target = pending.target
        self.tool_at_dest = reached if target is None else self.base.inverse() @ target
        self.given.stayed = None
        self.leg = corner.leg
        self._end(corner.pieces[-1][1], pending.intent.settings)
        self._carry_out_request(pending.intent)
        self.tell()

    def take_back(self, now: float) -> None:
        """Forget the motion that waits its turn: the one under way ends at its own target.

        A motion whose turn has come since the last tick is not taken back, but begins.
        """
        pending = self.pending
        if pending is None:
            return
        if pending.start_s < self.scale.path(now) - INSTANT:
            self.commit()
            self.overdue = True
            return
        self.pending = None
        self.given.put_back(pending.replaced)
        self.given.motions.pop()
        self.given.change_last(end_s=self.given.end_s, blended=False)

    def hold(self, start_s: float, seconds: float, number: int) -> None:
        """Stand still for a time, as DELAY does: a motion to nowhere.

        Args:
            start_s: Run time at which it begins [s]; the arm stands still then.
            seconds: How long it lasts at least [s].
            number: Statements that are finished when this one is.
        """
        ticks = math.ceil(max(seconds, 0.0) / self.arm.tick - TICK_TOLERANCE)
        self.hold_until = start_s + ticks * self.arm.tick
        self.leg = None
        if self.facts is not None:
            end_s = self.hold_until if ticks else self.motion_end
            self.facts.ends.note(start_s, number, end_s)

    def brake(self, now: float) -> bool:
        """Slow down to rest along the path and give the motion up; return whether one was cut."""
        cut = self._brake(now)
        self.tell()
        return cut

    def _brake(self, now: float) -> bool:
        self.take_back(now)
        self.hold_until = min(self.hold_until, now)
        given, path_s = self.given, self.scale.path(now)
        if path_s >= given.end_s - INSTANT or self.braking_until > now:
            return False
        motion = given.motions[-1]
        if path_s < motion.start_s - INSTANT:  # it has not begun
            given.cut(motion.start_s)
            given.motions.pop()
            self._stop_at(path_s, motion.start)
            return True
        steady, rate = self.scale.rate, self.scale.rate_at(now)
        full = self.model.pace.brake_accelerations * self.arm.acceleration_time
        ramp = full * (rate / steady)
        stop_s = path_s + 0.5 * rate * ramp
        if stop_s >= given.end_s:
            return False  # it comes to rest by itself within that time
        self.braking_until = self.scale.stop(now, ramp)
        stopped = given.at(stop_s)
        given.cut(stop_s)
        X_WT = forward(self.arm, stopped) @ motion.X_FT
        given.change_last(end_s=stop_s, goal=stopped, X_WT=X_WT, cut=True)
        self._stop_at(stop_s, stopped)
        return True

    def set_rate(self, now: float, rate: float) -> None:
        """Go over to another monitor speed, given as a share of full speed."""
        if self.braking_until > now:
            self.scale.change_after_stop(rate)
        else:
            ramp = self.model.pace.monitor_accelerations * self.arm.acceleration_time
            self.scale.change(now, rate, ramp)
        self.tell()

    # --- noting -------------------------------------------------------------------------------

    def tell(self) -> None:
        """Note where the arm is to go now, and until when it moves."""
        if self.facts is not None:
            begin = self.configuration, self.branch, self.request
            self.facts.aim(Aim(self.dest, self.tool_at_dest, *begin), self.scale.rate)
            self.facts.end(self.motion_end, self.braking_until)

    def tell_settings(self) -> None:
        """Note which speeds hold now."""
        if self.facts is not None:
            self.facts.speed(*self.settings.speeds, turns=self.settings.always.multiple)

    # --- parts --------------------------------------------------------------------------------

    def _carry_out_request(self, intent: Intent) -> None:
        if intent.goal is not None and not intent.keeps_request:
            self.request = NOTHING_REQUESTED

    def _stop_at(self, path_s: float, q: Configuration) -> None:
        self.given.end_s, self.given.stayed = path_s, None
        self.configuration = q
        self.branch = branch_of(self.arm, q, self.branch, self.model.branches)
        self.leg = None

    def _end(self, path_s: float, settings: Settings) -> None:
        self.given.end_s = path_s
        self.settling_s = settings.settling_ticks(self.model.stops) * self.arm.tick
        self.hold_until = 0.0

    def _stay(self, path_s: float) -> None:
        """End a motion that went nowhere: the arm has stopped, and settled, before."""
        self.given.end_s, self.settling_s, self.hold_until = path_s, 0.0, 0.0

    def _remark(self, fast: Overspeed | None, others: tuple[Remark, ...]) -> None:
        """Keep what is told of the last motion."""
        told = others if fast is None else (fast, *others)
        self.remarks[len(self.given.motions) - 1] = told

    def _leg(self, planned: Planned, intent: Intent, start: float) -> Leg:
        deceleration = intent.settings.acceleration_times(self.arm)[1]
        departure = start + planned.profile.rise
        return Leg(planned.path, planned.profile, departure, deceleration)

    def _motion(
        self,
        intent: Intent,
        start: float,
        end: float,
        goal: Configuration,
        deviation_m: float,
        cause: Cause,
    ) -> Motion:
        return Motion(
            intent.interpolation,
            start,
            end,
            intent.start,
            goal,
            forward(self.arm, goal) @ self.tool,
            self.tool,
            intent.fraction,
            deviation_m,
            cause,
        )
