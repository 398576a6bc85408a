"""Expressions of the language, worked out at any instant of a run.

The controller works them out itself, on a fork of the run that is thrown away: what it would
answer if it were asked at that instant.
"""

from collections.abc import Mapping, Sequence

from vrts.base.source import SourceFile
from vrts.debug.passages import Instant
from vrts.engine.controller import forked
from vrts.engine.memory.events import CommandRefused, Found
from vrts.engine.run import Run
from vrts.ir.commands import Command, Do, Panic, SetVariable, TimedCommand
from vrts.ir.module import Module
from vrts.ir.values import Value
from vrts.lang.dialect import Dialect
from vrts.lang.names import key
from vrts.monitor import words
from vrts.monitor.desk import ALONE, ANSWER
from vrts.monitor.programs import in_view

LONGEST = 250  # characters


class CannotTell(ValueError):  # noqa: N818 -- names the situation
    """An expression has no value; the text says why."""


def evaluate(
    run: Run,
    at: Instant,
    text: str,
    dialect: Dialect,
    seen: Mapping[str, Value | None] | None = None,
) -> Value:
    """Return the value of an expression at an instant.

    Args:
        run: A run that can go on.
        at: When it is asked.
        text: A real, a string, a transformation or a precision point; one line.
        dialect: Of the program.
        seen: Arguments and automatic variables, None for those without a value: they hide what is
            global. Left out: those of the innermost robot program.

    Raises:
        CannotTell: It cannot be read, or has no value then.
    """
    state = run.at_moment(at.time_s, at.finished)
    seen = state.locals if seen is None else seen
    simple = _in_force(state.variables, seen).get(key(text.replace(" ", "").strip()))
    if simple is not None:
        return simple
    target, module = read(text, state.variables, seen, dialect)
    answer = worked_out(run, at, module, seen)
    if isinstance(answer, str):
        raise CannotTell(answer.strip())
    return answer[target]


def read(
    text: str, variables: Mapping[str, Value], seen: Mapping[str, Value | None], dialect: Dialect
) -> tuple[str, Module]:
    """Return an expression as a step that gives its value to a variable, and that variable.

    Args:
        text: As for `evaluate`.
        variables: What has a value, which tells the kinds of names.
        seen: Arguments and automatic variables, as for `evaluate`.
        dialect: Of the program.

    Raises:
        CannotTell: It cannot be read.
    """
    text = text.strip()
    if not text or len(text) > LONGEST or "\n" in text:
        raise CannotTell("an expression is one line of at most 250 characters")
    known = _in_force(variables, seen)
    first = ""
    for target in _targets(text, dialect):
        found = _module(f"{target} = {text}", known, dialect)
        if not isinstance(found, str):
            return key(target.split()[-1]), found
        first = first or found
    raise CannotTell(first)


def _in_force(
    variables: Mapping[str, Value], seen: Mapping[str, Value | None]
) -> Mapping[str, Value]:
    """Return the values by name: what is local hides what is global, without a value too."""
    inside = {name.partition("[")[0] for name in seen}
    found = {n: v for n, v in variables.items() if n.partition("[")[0] not in inside}
    found.update({name: value for name, value in seen.items() if value is not None})
    return found


def worked_out(
    run: Run, at: Instant, module: Module, seen: Mapping[str, Value | None]
) -> Mapping[str, Value] | str:
    """Execute a module of one step beside a run; return the variables then, or why it failed."""
    commands: list[Command] = [_known_as(name, value) for name, value in seen.items()]
    commands += [Panic(), Do(module)]  # which a program that is being executed would exclude
    until = at.time_s + 2.0 * run.history.tick_s
    timed = commands_at(run, at, commands)
    fork = forked(run, timed, max(until, timed[0].time_s + 2.0 * run.history.tick_s))
    for event, number in zip(fork.events, fork.event_numbers, strict=True):
        if number > at.finished:
            if isinstance(event, CommandRefused):
                return words.starred(event.words)
            if isinstance(event, Found) and event.diagnostic.is_error:
                return event.diagnostic.headline
    return fork.at(fork.horizon_s).variables


def commands_at(run: Run, at: Instant, commands: Sequence[Command]) -> list[TimedCommand]:
    """Return commands that take effect at an instant: within its tick where it is within one."""
    tick = run.history.tick_s
    on_tick = abs(at.time_s / tick - round(at.time_s / tick)) < 1e-6
    after = at.finished if on_tick else None
    return [TimedCommand(at.time_s, command, after) for command in commands]


def _known_as(name: str, value: Value | None) -> SetVariable:
    """Return what makes a local variable one that a step of its own can read."""
    base, _, inside = name.rstrip("]").partition("[")
    return SetVariable(
        base, tuple(int(part) for part in inside.split(",")) if inside else (), value
    )


def _targets(text: str, dialect: Dialect) -> tuple[str, ...]:
    set_ = "POINT" if dialect.is_as else "SET"
    real, string = ANSWER, f"${ANSWER}"
    pose, joints = f"{set_} {ANSWER}", f"{set_} #{ANSWER}"
    if text[0] in '$"':
        return string, real
    if text[0] == "#":
        return joints, real
    return real, pose, string, joints


def _module(step: str, known: Mapping[str, Value], dialect: Dialect) -> Module | str:
    """Return a step as a program of its own, or why it is none."""
    source = SourceFile("expression", f".PROGRAM {ALONE}\n{step}\n.END\n")
    found = in_view(source, (step,), {}, known, dialect)
    error = next((d for d in found.diagnostics if d.is_error), None)
    if error is not None or found.module is None:
        return error.headline if error is not None else "this is no expression"
    return Module({ALONE: found.module.programs[ALONE]}, ())
