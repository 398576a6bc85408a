"""Instructions that move the arm, or keep it where it is, as closures: how one follows another."""

from vrts.engine.code.closures import BLOCKED, Step, reached
from vrts.engine.code.steps.hand_steps import command_hand
from vrts.engine.code.steps.targets import MotionInstruction, Target, TargetCompiler
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import INSTANT
from vrts.engine.motion.plan import Intent
from vrts.engine.motion.requests import to_joints, to_line, to_pose
from vrts.engine.programs.context import Context
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression

# what a motion instruction that waits has come to
JOINED, WAITED, CUT_SHORT, REACHED = 1, 2, 3, 4


class MotionStepCompiler:
    """Compiles motions."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions
        self.targets = TargetCompiler(expressions)

    def motion(self, instruction: MotionInstruction, following: int, cause: Cause) -> Step:
        """Return the step of an instruction that moves the arm.

        It waits until the motion under way can be followed: by a rounded corner if it is known
        early enough, else when that motion has ended.
        """
        evaluate = self.targets.target(instruction, cause)

        def move(c: Context) -> int:
            planner = c.planner
            if c.phase == CUT_SHORT:
                if not reached(c, planner.settled_at):
                    return BLOCKED
                fault, c.fault, c.phase = c.fault, None, 0
                assert fault is not None
                if _given_up(c, cause):
                    return following  # it never came to where it would have failed
                raise fault
            if c.phase == JOINED:
                pending = planner.pending
                if pending is not None:
                    start = planner.scale.time(pending.start_s)
                    if not reached(c, start):
                        return BLOCKED
                    planner.commit()
                    return begun(c, start)
                if planner.overdue:
                    planner.overdue = False
                    return begun(c, c.now)
                c.phase = REACHED  # it was taken back: a reaction came between
            if c.phase == 0:
                c.operands, c.phase = evaluate(c), REACHED
            target = c.operands
            assert isinstance(target, Target)
            if planner.free_at > c.now + INSTANT:
                if c.phase == REACHED and _joins(c, target, cause):
                    assert planner.pending is not None
                    c.phase, c.wake = JOINED, planner.scale.time(planner.pending.start_s)
                    return BLOCKED
                c.phase, c.wake = WAITED, planner.free_at
                return BLOCKED
            # a command waited for this tick already, which is the next one after it was given
            due = c.phase == WAITED or c.at_once
            ticks = 0 if due else planner.model.pace.departure_ticks
            start = c.after(ticks)
            intent = _intent(c, target)
            dry = c.system.is_on("DRY.RUN")
            c.fault = planner.begin(intent, start, target.pose, cause, dry=dry)
            if c.fault is not None:
                c.phase, c.wake = CUT_SHORT, planner.settled_at
                c.until = float(len(planner.given.motions) - 1)
                return BLOCKED
            return begun(c, start)

        def begun(c: Context, start: float) -> int:
            target = c.operands
            assert isinstance(target, Target)
            if target.opening is not None:
                opens = target.opening > 0.0
                action = ir.HandAction.OPEN if opens else ir.HandAction.CLOSE
                c.next_hand.append((action, cause))
            _begin_hand(c, start)
            c.phase, c.operands = 0, None
            c.hand.path_changed(c.now)
            return following

        return move

    def delay(self, time: Expression, following: int) -> Step:
        """Return the step of DELAY: it waits its turn like a motion.

        Whether it counts as the next motion for settings and for the hand is the controller
        model's to say [manual language/motion#delay].
        """
        seconds = self.expressions.real(time)

        def delay(c: Context) -> int:
            planner, counts = c.planner, c.planner.model.next_motion
            if counts.delay_uses_settings and c.phase == 0:
                if planner.settings.next:
                    planner.take_settings()
                c.phase = WAITED
            if not reached(c, planner.free_at):
                return BLOCKED
            c.phase = 0
            planner.hold(c.now, seconds(c), c.finished)
            if counts.delay_moves_hand:
                _begin_hand(c, c.now)
            return following

        return delay


def _begin_hand(c: Context, start: float) -> None:
    """Begin what OPEN, CLOSE and RELAX left to the next motion."""
    for action, by in c.next_hand:
        command_hand(c, action, start, by)
    c.next_hand = []


def _intent(c: Context, target: Target) -> Intent:
    planner = c.planner
    if target.drive is not None:  # from where the arm will be then: other joints stand still
        joint, change = target.drive
        start = planner.dest if c.system.is_on("DRY.RUN") else planner.configuration
        goal = (*start[:joint], start[joint] + change, *start[joint + 1 :])
        intent = to_joints(planner.stance, goal, target.settings, target.fraction, target.span)  # type: ignore[arg-type]
        return intent._replace(keeps_request=True)
    if target.joints is not None:
        return to_joints(
            planner.stance, target.joints, target.settings, target.fraction, target.span
        )
    assert target.pose is not None
    if target.interpolation is ir.Interpolation.LINEAR:
        return to_line(planner.stance, target.pose, target.settings, target.fraction, target.span)
    return to_pose(planner.stance, target.pose, target.settings, target.fraction, target.span)


def _given_up(c: Context, cause: Cause) -> bool:
    """Return whether the motion of a step, whose number `until` keeps, was given up on its way."""
    motions, number = c.planner.given.motions, int(c.until)
    return number >= len(motions) or motions[number].cut or motions[number].cause != cause


def _joins(c: Context, target: Target, cause: Cause) -> bool:
    """Join a motion to the one under way, if it can be."""
    if not c.system.is_on("CP") or c.system.is_on("DRY.RUN"):
        return False
    try:
        intent = _intent(c, target)
    except RuntimeFault:
        return False  # it is raised again when the motion's turn comes
    if not c.planner.join(intent, c.now, target.pose, cause):
        return False
    c.hand.path_changed(c.now)
    return True
