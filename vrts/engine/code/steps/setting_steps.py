"""Settings of motions, as closures."""

from collections.abc import Callable

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.engine.code.closures import BLOCKED, Step, reached
from vrts.engine.code.steps.targets import positive
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.operands import span_of
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.events import Cause, SpeedChanged
from vrts.engine.motion.settings import Speed
from vrts.engine.programs.context import Context
from vrts.engine.programs.locks import Wish, refused
from vrts.ir import instructions as ir
from vrts.ir.expressions import Expression
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.robots.kinematics.branch import has_branches

NO_BRANCHES = Rule("V330", "no-arm-branches")

SettingInstruction = (
    ir.SetSpeed
    | ir.SetMonitorSpeed
    | ir.SetAcceleration
    | ir.SetDuration
    | ir.SetAccuracy
    | ir.SetNulling
    | ir.SetIntegration
    | ir.SetTurns
)


class SettingStepCompiler:
    """Compiles settings."""

    def __init__(self, expressions: Compiler) -> None:
        """Share the compiler of expressions."""
        self.expressions = expressions

    def setting(self, instruction: SettingInstruction, following: int, cause: Cause) -> Step:
        """Return the step of a setting."""
        if isinstance(instruction, ir.SetMonitorSpeed):
            return self._monitor_speed(instruction, following, cause)
        if isinstance(instruction, ir.SetSpeed):
            return self._speed(instruction, following)
        values = self._values(instruction, cause)
        scope = instruction.scope

        def keep(c: Context) -> int:
            found, settings = values(c), c.planner.settings
            if scope is ir.Scope.ALWAYS:
                settings.always = settings.always._replace(**found)  # type: ignore[arg-type]
                c.planner.tell_settings()
            else:
                settings.next.update(found)
            return following

        return keep

    def _speed(self, instruction: ir.SetSpeed, following: int) -> Step:
        unit, span = instruction.unit, span_of(instruction.value)
        percent = self.expressions.real(instruction.value)
        rotation = instruction.rotation
        share = None if rotation is None else self.expressions.real(rotation)

        def always(c: Context) -> int:
            speed = positive(Speed(percent(c), unit), span)
            turning = None if share is None else share(c)
            settings = c.planner.settings
            held = settings.always
            if held.speed != speed or held.rotation != turning:
                settings.always = held._replace(speed=speed, rotation=turning)
                c.planner.tell_settings()
            return following

        def once(c: Context) -> int:
            speed = positive(Speed(percent(c), unit), span)
            turning = None if share is None else share(c)
            kept, facts = c.planner.settings.next, c.planner.facts
            kept["speed"], kept["rotation"] = speed, turning
            if facts is not None:
                track, value = facts.next_speeds, speed.value
                if track.values[-1] != value:
                    track.times.append(c.now)
                    track.numbers.append(c.finished)
                    track.values.append(value)  # type: ignore[arg-type]
            return following

        return always if instruction.scope is ir.Scope.ALWAYS else once

    def _values(
        self, instruction: SettingInstruction, cause: Cause
    ) -> Callable[[Context], dict[str, object]]:
        e = self.expressions
        match instruction:
            case ir.SetAcceleration(acceleration=acceleration, deceleration=deceleration):
                up = self._percent(acceleration, cause)
                down = self._percent(deceleration, cause)

                def percentages(c: Context) -> dict[str, object]:
                    found: dict[str, object] = {}
                    if up is not None:
                        found["acceleration"] = _allowed(c, up(c), cause)
                    if down is not None:
                        found["deceleration"] = _allowed(c, down(c), cause)
                    return found

                return percentages
            case ir.SetDuration(time=time):
                least = e.real(time)
                return lambda c: {"duration": max(least(c), 0.0)}
            case ir.SetAccuracy(accuracy=accuracy, percent=percent):
                share = e.real(percent) if percent is not None else None
                return lambda c: {
                    "accuracy": accuracy,
                    "accuracy_percent": share(c) if share is not None else 100.0,
                }
            case ir.SetNulling(on=on):
                return lambda c: {"nulling": on}
            case ir.SetIntegration(on=on):
                return lambda c: {"integration": on}
            case ir.SetTurns(multiple=multiple):
                return lambda c: {"multiple": multiple}
            case ir.SetMonitorSpeed() | ir.SetSpeed():
                raise ValueError("speeds have steps of their own")

    def _percent(
        self, operand: Expression | None, cause: Cause
    ) -> Callable[[Context], float] | None:
        if operand is None:
            return None
        value = self.expressions.real(operand)

        def percent(c: Context) -> float:
            found = value(c)
            if not 1.0 <= found <= 1000.0:
                raise RuntimeFault(
                    RuntimeErrorKind.ILLEGAL_VALUE,
                    f"an acceleration of {found:g} % is outside 1 to 1000",
                    cause.span,
                )
            return found

        return percent

    def _monitor_speed(self, instruction: ir.SetMonitorSpeed, following: int, cause: Cause) -> Step:
        value = self.expressions.real(instruction.value)

        def set_speed(c: Context) -> int:
            change_monitor_speed(c, value(c), cause)
            return following

        return set_speed

    def branch(self, instruction: ir.RequestBranch, following: int, cause: Cause) -> Step:
        """Return the step of RIGHTY .. NOFLIP."""
        branch = instruction.branch

        def request(c: Context) -> int:
            waits = c.planner.model.stops.branch_words_wait
            if waits and not reached(c, c.planner.settled_at):
                return BLOCKED
            if has_branches(c.planner.arm):
                c.planner.ask(branch)
            elif "branches" not in c.system.warned:
                c.system.warned |= {"branches"}
                c.report(_no_branches(c, cause), cause)
            return following

        return request


def _allowed(c: Context, percent: float, cause: Cause) -> float:
    """Return an acceleration, at most what a program may ask for."""
    most = c.system.locks.acceleration
    if percent > most:
        refused(c, Wish("ACCEL", f"ACCEL {percent:g}", f"{most:g} % is the most"), cause)
    return min(percent, most)


def change_monitor_speed(c: Context, percent: float, cause: Cause | None) -> None:
    """Change the operator's speed from this tick on.

    Raises:
        RuntimeFault: It is not above zero.
    """
    if percent <= 0.0:
        raise RuntimeFault(
            RuntimeErrorKind.ILLEGAL_VALUE,
            "a speed must be above zero",
            cause.span if cause else None,
        )
    percent = min(percent, c.planner.model.pace.most_monitor_percent)
    c.planner.set_rate(c.now, percent / 100.0)
    c.hand.path_changed(c.now)
    c.look_again()
    c.events.append(SpeedChanged(c.now, percent, cause))


def _no_branches(c: Context, cause: Cause) -> Diagnostic:
    return Diagnostic(
        NO_BRANCHES,
        Severity.WARNING,
        f"`{cause.span.text}` means nothing to the {c.planner.arm.title}",
        Label(cause.span, "ignored, as are later words of this kind"),
        notes=("only arms of the PUMA family have these arm branches",),
    )
