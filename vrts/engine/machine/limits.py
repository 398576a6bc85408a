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
    if machine.finished > limits.statements:
        raise _reached(
            c,
            STATEMENTS,
            f"the program is still running after {limits.statements:,} steps",
            f"it was stopped here, after {elapsed:.0f} s of simulated time{_share(machine)}",
            "check that every loop comes to an end",
        )
    if elapsed > limits.time_s:
        raise _reached(
            c,
            SIMULATED_TIME,
            f"the program is still running after {limits.time_s:.0f} s",
            "it was stopped here, at the longest time it may take",
            "if no loop repeats for ever, the arm is too slow: look at SPEED",
        )
    if len(system.planner.motions) > limits.motions:
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


def _share(machine: Machine) -> str:
    """Return how many of the statements the process control program has executed, if any."""
    process = machine.process
    many = process.trace.executed(machine.finished)
    return f"; {many:,} of the steps are of `{process.program}`" if many else ""


def _reached(c: Context, rule: Rule, headline: str, note: str, remedy: str) -> LimitReached:
    cause = place(c)
    assert cause is not None
    return LimitReached(rule, headline, cause.span, note, remedy)
