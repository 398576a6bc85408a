"""Limits of a run: each is a diagnostic, and ends the program."""

from vrts.base.diagnostic import Rule
from vrts.engine.faults import (
    MOTIONS,
    OUTPUT,
    SIMULATED_TIME,
    STATEMENTS,
    LimitReached,
)
from vrts.engine.machine.machine import Machine
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import place


def check_limits(machine: Machine, c: Context) -> None:
    """Check the limits of a run, once in a tick; a program that is over keeps them.

    Raises:
        LimitReached: One is exceeded.
    """
    over = machine.closed and not machine.robot.running  # what goes on beside it is no fault
    if not c.running or (over and not c.is_robot):
        return
    limits = machine.scenario.limits
    elapsed = c.now - c.started_s
    system = machine.system
    # of two programs the robot program is ended, and once it is told which of them it was
    if machine.finished > limits.statements and (c.is_robot or not machine.robot.running):
        raise _too_many(machine, c)
    if elapsed > limits.time_s:
        raise _reached(
            c,
            SIMULATED_TIME,
            f"the program is still running after {limits.time_s:.0f} s",
            "it was stopped here, at the longest time it may take",
            "if no loop repeats for ever, the arm is too slow: look at SPEED",
        )
    if len(system.planner.given.motions) > limits.motions:
        raise _reached(
            c,
            MOTIONS,
            f"the program makes more than {limits.motions:,} motions",
            "it was stopped here",
            "check that every loop comes to an end",
        )
    if system.terminal.characters > limits.output_characters:
        raise _reached(
            c,
            OUTPUT,
            f"the program writes more than {limits.output_characters:,} characters",
            "it was stopped here",
            "check the loop that writes",
        )


def _too_many(machine: Machine, c: Context) -> LimitReached:
    """Return that there were too many statements, at the program that executed most of them."""
    process, most = machine.process, machine.scenario.limits.statements
    many = process.trace.executed(machine.finished)
    remedy = "check that every loop comes to an end"
    lasted = f"after {c.now - c.started_s:.0f} s of simulated time"
    if c.is_robot and process.running and 2 * many > machine.finished:
        return _reached(
            process,
            STATEMENTS,
            f"`{process.program}` is still running beside `{c.program}` after {most:,} steps",
            f"it was here, {lasted}; {many:,} of the steps are its own",
            f"{remedy}, or let `{process.program}` wait in its loop: `DELAY`, `WAIT`",
        )
    share = f"; {many:,} of the steps are of `{process.program}`" if many and c.is_robot else ""
    return _reached(
        c,
        STATEMENTS,
        f"the program is still running after {most:,} steps",
        f"it was stopped here, {lasted}{share}",
        remedy,
    )


def _reached(c: Context, rule: Rule, headline: str, note: str, remedy: str) -> LimitReached:
    cause = place(c)
    assert cause is not None
    return LimitReached(rule, headline, cause.span, note, remedy)
