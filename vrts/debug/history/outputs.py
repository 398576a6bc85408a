"""Changes of signals, switches, analog outputs and the operator's speed."""

from collections.abc import Callable, Iterator

from vrts.debug.history.track import Moment, Track, joined
from vrts.debug.passages import Instant, executes
from vrts.engine.memory.events import (
    AnalogChanged,
    Cause,
    Event,
    SignalChanged,
    SpeedChanged,
    SwitchChanged,
)
from vrts.engine.memory.records import INSTANT
from vrts.engine.run import Run


def of_signal(run: Run, signal: int) -> Track:
    """Return the changes of a signal."""

    def fits(event: Event) -> bool:
        return isinstance(event, SignalChanged) and event.signal == signal

    return Track(
        run,
        f"signal {signal}",
        lambda at: signal in run.at_moment(at.time_s, at.finished).signals,
        _events(run, fits),
    )


def of_switch(run: Run, switch: str) -> Track:
    """Return the changes of a switch."""

    def fits(event: Event) -> bool:
        return isinstance(event, SwitchChanged) and event.switch == switch

    return Track(
        run,
        f"the switch {switch}",
        lambda at: run.at_moment(at.time_s, at.finished).switches.get(switch, False),
        _events(run, fits),
    )


def of_analog(run: Run, channel: int) -> Track:
    """Return the changes of an analog output [counts]."""

    def fits(event: Event) -> bool:
        return isinstance(event, AnalogChanged) and event.channel == channel

    return Track(
        run,
        f"analog output {channel}",
        lambda at: run.at_moment(at.time_s, at.finished).analog.get(channel, 0.0),
        _events(run, fits),
    )


def of_speed(run: Run) -> Track:
    """Return the changes of the operator's speed [%]."""
    return Track(
        run,
        "the operator's speed",
        lambda at: run.at_moment(at.time_s, at.finished).monitor_speed,
        _events(run, lambda event: isinstance(event, SpeedChanged)),
    )


def _events(run: Run, fits: Callable[[Event], bool]) -> list[Moment]:
    return joined(_moments(run, fits))


def _moments(run: Run, fits: Callable[[Event], bool]) -> Iterator[Moment]:
    for event, number in zip(run.events, run.event_numbers, strict=True):
        if not fits(event) or event.time_s > run.horizon_s:
            continue
        cause: Cause | None = event.cause
        at_once = abs(run.history.time_of(number) - event.time_s) < INSTANT
        done = number if cause is not None and at_once and _did(run, number, cause) else None
        by = "" if cause is not None else "from outside"
        yield Moment(Instant(event.time_s, number), event.time_s, done, cause, by)


def _did(run: Run, number: int, cause: Cause) -> bool:
    """Return whether a statement is one of the step."""
    listed = run.history.code.causes
    done = (executes(run, number, process=process) for process in (False, True))
    return any(instruction is not None and listed[instruction] == cause for instruction in done)
