"""The state of a run at one instant, for the terminal. Lengths in mm, angles in degrees."""

from collections.abc import Iterator, Mapping, Sequence

from vrts.base.oat import components
from vrts.base.pose import IDENTITY, Pose
from vrts.base.units import deg, mm
from vrts.engine.code.values.formats import free
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import Lie, Placement, ProgramState, ProgramStatus
from vrts.engine.run import Run, State
from vrts.ir.system import SWITCHES
from vrts.ir.values import Value
from vrts.report.plain import one_line, plain_text

LABEL = 8  # columns of what begins a row
NUMBER = 10  # of a number
MOST_OUTPUT = 20  # lines of the terminal, the last ones
MOST_VARIABLES = 200


def state_text(run: Run, state: State) -> str:
    """Return everything known about an instant of a run."""
    parts = (
        _when(state),
        _programs(run, state),
        _arm(state),
        _objects(state),
        _system(state),
        _values("arguments and automatic variables", state.locals),
        _values("variables", state.variables),
        _output(state.output),
    )
    return plain_text("\n\n".join("\n".join(lines) for part in parts if (lines := list(part))))


def _when(state: State) -> Iterator[str]:
    count = state.finished
    yield f"at {state.time_s:.3f} s, {count:,} statement{'' if count == 1 else 's'} finished"


def _programs(run: Run, state: State) -> Iterator[str]:
    cause = state.cause
    stack = state.call_stack
    if cause is not None:
        yield _row("line", f"{_place(cause)}  {one_line(cause.span.text)}")
    if stack and stack[-1] != cause:
        yield _row("next", f"{_place(stack[-1])}  {one_line(stack[-1].span.text)}")
    for caller in reversed(stack[:-1]):
        yield _row("called", f"{_place(caller)}  {one_line(caller.span.text)}")
    if run.ended_s is not None and state.time_s >= run.ended_s:
        yield _row("ended", f"{run.ending.value} at {run.ended_s:.3f} s")
    process = state.process
    if process is not None and process.status is not ProgramStatus.NOT_RUNNING:
        yield _row("process", _process(process))


def _process(process: ProgramState) -> str:
    words = f"{one_line(process.program)} {process.status.value}"
    cause = process.cause
    return words if cause is None else f"{words}: {_place(cause)}  {one_line(cause.span.text)}"


def _place(cause: Cause) -> str:
    return f"{cause.span.line:>4}  {one_line(cause.program)} {cause.step}:"


def _arm(state: State) -> Iterator[str]:
    yield _header("JT1 JT2 JT3 JT4 JT5 JT6")
    yield _row("deg", _numbers([deg(q) for q in state.configuration], 3))
    yield _row("deg/s", _numbers([deg(rate) for rate in state.velocity], 2))
    yield _header("X Y Z O A T")
    yield _row("tool", _pose(state.X_WT))
    if state.X_FT != IDENTITY:
        yield _row("TOOL", _pose(state.X_FT))
    if state.base != IDENTITY:
        yield _row("BASE", _pose(state.base))
    hand = f"{mm(state.hand_opening):{NUMBER}.2f} mm"
    yield _row("hand", f"{hand}, holds {one_line(state.held)}" if state.held else hand)


def _objects(state: State) -> Iterator[str]:
    poses = state.poses
    placements = state.placements
    width = max([LABEL, *(len(one_line(name)) for name in placements)])
    for name, placement in placements.items():
        yield f"  {one_line(name):<{width}}{_pose(poses[name])}  {_lie(placement)}"


def _lie(placement: Placement) -> str:
    on = one_line(placement.support or "")
    match placement.lie:
        case Lie.HELD:
            return f"carried on {on}" if on else "in the hand"
        case Lie.FALLING:
            return "falling"
        case Lie.TOPPLED:
            return f"cannot stand on {on}" if on else "let go over nothing"
        case Lie.RESTING:
            return f"on {on}" if on else ""


def _system(state: State) -> Iterator[str]:
    on = ", ".join(map(str, sorted(state.signals)))
    yield _row("signals", f"{on} on" if on else "all off")
    yield _row("speed", f"{state.program_speed:g} %, the operator's {state.monitor_speed:g} %")
    changed = [
        f"{name} {'on' if is_on else 'off'}"
        for name, is_on in sorted(state.switches.items())
        if name in SWITCHES and SWITCHES[name].on is not is_on
    ]
    if changed:
        yield _row("switches", ", ".join(changed))
    for name, value in sorted(state.parameters.items()):
        yield _row("", f"PARAMETER {one_line(name)} = {free(value)}")
    for channel, value in sorted(state.analog.items()):
        yield _row("", f"analog output {channel} = {free(value)}")


def _values(title: str, values: Mapping[str, Value]) -> Iterator[str]:
    if not values:
        return
    yield f"  {title}"
    names = sorted(values)
    width = min(max(len(one_line(name)) for name in names), 20)
    for name in names[:MOST_VARIABLES]:
        yield f"    {one_line(name):<{width}} = {_value(values[name])}"
    if len(names) > MOST_VARIABLES:
        yield f"    and {len(names) - MOST_VARIABLES:,} more"


def _value(value: Value) -> str:
    if isinstance(value, Pose):
        return _pose(value)
    if isinstance(value, tuple):
        return _numbers([deg(part) for part in value], 3)
    return one_line(f'"{value}"') if isinstance(value, str) else free(value)


def _output(output: str) -> Iterator[str]:
    if not output:
        return
    lines = output.replace("\r\n", "\n").split("\n")
    if not lines[-1]:
        lines.pop()
    hidden = len(lines) - MOST_OUTPUT
    yield "  terminal" + (f", the last {MOST_OUTPUT} of {len(lines):,} lines" if hidden > 0 else "")
    for line in lines[-MOST_OUTPUT:]:
        yield f"    | {line}"


# --- rows -----------------------------------------------------------------------------------------


def _row(label: str, words: str) -> str:
    return f"  {label:<{LABEL}}{words}"


def _header(names: str) -> str:
    return _row("", "".join(f"{name:>{NUMBER}}" for name in names.split()))


def _pose(X: Pose) -> str:
    parts = components(X)
    return _numbers(parts[:3], 2) + _numbers(parts[3:], 3)


def _numbers(values: Sequence[float], decimals: int) -> str:
    return "".join(f"{round(value, decimals) + 0.0:{NUMBER}.{decimals}f}" for value in values)
