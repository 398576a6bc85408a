"""When something changes: a variable, a location, a signal, an argument of one call."""

import re
from bisect import bisect_left
from collections.abc import Iterator
from typing import NamedTuple

from vrts.debug.conditions.hearing import Hear, nobody
from vrts.debug.evaluating import CannotTell
from vrts.debug.frames import Frame
from vrts.debug.passages import Instant, executes, instant_of
from vrts.engine.history import ProgramHistory
from vrts.engine.memory.cells import UNDEFINED, Cell, Content, Undefined, cells_of
from vrts.engine.memory.events import SignalChanged
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run
from vrts.ir.ranges import INPUTS, INTERNAL, OUTPUTS
from vrts.lang.names import key
from vrts.monitor.listings import value_text

_SIGNAL = re.compile(r"(?:SIG|SIGNAL)?\s*\(?\s*(\d{1,5})\s*\)?", re.IGNORECASE)
_OF_CALL = re.compile(r"(?P<name>[^@]{1,80}) @ (?P<program>[\w.]{1,40}) (?P<call>\d{1,9})")

OFTEN = 256  # changes that are looked at before somebody is heard again


class Change(NamedTuple):
    """Something has just changed."""

    instant: Instant  # right after it
    text: str  # what it was and what it is
    process: bool = False  # the process control program did it, or it is of one of its calls
    call: Activation | None = None  # whose argument or automatic variable it is


class Watchable(NamedTuple):
    """Something whose changes may be watched."""

    name: str  # as `changes` takes it
    words: str  # what it is, for people


def watchable(run: Run, name: str, frame: Frame | None = None) -> Watchable:
    """Return what a typed name is to be watched as, where the debugger stands.

    An argument or automatic variable is watched for the one call that the frame stands for.

    Args:
        run: What happened.
        name: As somebody typed it.
        frame: Whose arguments and automatic variables hide what is global; None: nobody's.

    Raises:
        CannotTell: There is nothing of this name to watch.
    """
    wanted = key(name.strip().replace(" ", ""))
    base = wanted.partition("[")[0]
    if frame is not None and frame.activation is not None and base in frame.declared(run):
        history = run.history.process if frame.process else run.history.robot
        calls = _calls(run, history, frame.cause.program)
        number = next(k for k, (_, a) in enumerate(calls, 1) if a is frame.activation)
        words = f"`{wanted}` of `{frame.cause.program}`, in its {_ordinal(number)} call only"
        return Watchable(f"{wanted} @ {frame.cause.program} {number}", words)
    signal = _SIGNAL.fullmatch(name.strip())
    if signal is not None:
        number = int(signal[1])
        if not any(number in known for known in (INPUTS, OUTPUTS, INTERNAL)):
            raise CannotTell(f"there is no signal {number}")
        return Watchable(f"SIG({number})", f"signal {number}")
    for bound in run.history.memory.bound:
        if wanted in (bound.name, *(cell.name for cell in cells_of(bound))):
            return Watchable(wanted, f"`{wanted}`")
    raise CannotTell(f"there is no variable or signal `{name.strip()[:60]}` here")


def changes(run: Run, name: str, hear: Hear = nobody) -> list[Change]:
    """Return every change of what a name stands for, in order.

    Args:
        run: What happened.
        name: A variable as states list it (`x`, `$s`, `a[3]`, `#safe`), an array (`a`: any of its
            elements), a signal (`1001`, `SIG(1001)`), or what `watchable` names: `n @ twice 2` is
            the argument `n` in the second call of `twice`.
        hear: Who is heard meanwhile.

    Raises:
        Interrupted: `hear` has heard somebody.
    """
    of_call = _OF_CALL.fullmatch(name)
    if of_call is not None:
        call = _of_call(run, of_call["name"], of_call["program"], int(of_call["call"]))
        return sorted(_heard(call, hear), key=_order)
    signal = _SIGNAL.fullmatch(name.strip())
    if signal is not None:
        return list(_heard(_of_signal(run, int(signal[1])), hear))
    wanted = key(name.strip().replace(" ", ""))
    found: list[Change] = []
    for bound in run.history.memory.bound:
        if bound.name == wanted or wanted.startswith(f"{bound.name}["):
            for cell in cells_of(bound):
                if wanted in (bound.name, cell.name):
                    found += _heard(_of_cell(run, cell, cell.name), hear)
    return sorted(found, key=_order)


def _heard(found: Iterator[Change], hear: Hear) -> Iterator[Change]:
    for k, change in enumerate(found):
        if k % OFTEN == 0:
            hear()
        yield change


def _order(change: Change) -> tuple[Instant, str]:
    return change.instant, change.text


def _by_process(run: Run, number: int) -> bool:
    """Return whether a statement was one of the process control program."""
    return executes(run, number, process=True) is not None


def _of_signal(run: Run, signal: int) -> Iterator[Change]:
    for event, number in zip(run.events, run.event_numbers, strict=True):
        if isinstance(event, SignalChanged) and event.signal == signal:
            state = "on" if event.on else "off"
            by_process = event.cause is not None and _by_process(run, number)
            yield Change(Instant(event.time_s, number), f"signal {signal} is {state}", by_process)


def _of_cell(
    run: Run, cell: Cell, name: str, begin: int = 0, end: int | None = None
) -> Iterator[Change]:
    """Yield the changes of a cell after so many statements, before or at so many others."""
    before: Content = cell.at(begin) if begin else UNDEFINED
    for since in cell.since[bisect_left(cell.since, begin + 1) if begin else 0 :]:
        if since > (run.statements if end is None else end):
            return
        value = cell.at(since)
        if value != before:
            text = f"{name}: {_shown(before)} -> {_shown(value)}"
            yield Change(instant_of(run, since), text, _by_process(run, since))
        before = value


def _of_call(run: Run, name: str, program: str, call: int) -> Iterator[Change]:
    """Yield the changes of an argument or automatic variable while one call goes on."""
    for history in (run.history.robot, run.history.process):
        calls = _calls(run, history, program)
        if not 1 <= call <= len(calls):
            continue
        begin, activation = calls[call - 1]
        known = run.history.code.programs[activation.program]
        names = [slot.name for slot in (*known.formals, *known.autos)]
        base = name.partition("[")[0]
        if base not in names:
            continue
        bound = activation.slots[names.index(base)]
        end = _left(run, history, begin, activation)
        for cell in cells_of(bound):
            shown = base if isinstance(bound, Cell) else base + cell.name[cell.name.find("[") :]
            if name in (base, shown):
                for change in _of_cell(run, cell, shown, begin, end):
                    yield change._replace(process=history is run.history.process, call=activation)


def _calls(run: Run, history: ProgramHistory, program: str) -> list[tuple[int, Activation]]:
    """Return every call of a program: after how many statements it was entered, and itself."""
    trace, programs = history.trace, run.history.code.programs
    found: dict[int, tuple[int, Activation]] = {}
    for since, activation in zip(trace.changed, trace.activations, strict=True):
        if since > run.statements:
            break
        if activation is not None and programs[activation.program].name == program:
            found.setdefault(id(activation), (since, activation))
    return list(found.values())


def _left(run: Run, history: ProgramHistory, begin: int, activation: Activation) -> int:
    """Return after how many statements a call was over."""
    trace = history.trace
    for k in range(bisect_left(trace.changed, begin), len(trace.changed)):
        inside = trace.activations[k]
        while inside is not None and inside is not activation:
            inside = inside.caller
        if inside is None and trace.changed[k] > begin:
            return min(trace.changed[k], run.statements)
    return run.statements


def _ordinal(number: int) -> str:
    ending = {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th")
    return f"{number:,}{'th' if number % 100 in (11, 12, 13) else ending}"


def _shown(value: Content) -> str:
    return "undefined" if isinstance(value, Undefined) else value_text(value)
