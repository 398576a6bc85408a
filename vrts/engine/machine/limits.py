"""Limits of a run, and waits that never end: each is a diagnostic, and ends the program."""

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity
from vrts.engine.faults import (
    MOTIONS,
    OUTPUT,
    SIMULATED_TIME,
    STATEMENTS,
    WAIT_NEVER_ENDS,
    LimitReached,
)
from vrts.engine.machine.machine import Machine
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import place
from vrts.ir import instructions as ir

NO_ANSWER = Rule("V504", "no-answer")


def check_limits(machine: Machine, c: Context) -> None:
    """Check the limits of a run, once in a tick; a program that is over keeps them.

    Raises:
        LimitReached: One is exceeded.
    """
    if not c.running:
        return
    limits = machine.scenario.limits
    elapsed = c.now - c.started_s
    system = machine.system
    if machine.finished > limits.statements:
        raise _reached(
            c,
            STATEMENTS,
            f"the program is still running after {limits.statements:,} steps",
            f"it was stopped here, after {elapsed:.0f} s of simulated time",
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


def stuck(c: Context, now: float) -> Diagnostic:
    """Return what is wrong with a program that waits for something that never comes."""
    cause = place(c)
    assert cause is not None
    frame = c.frames[-1]
    program = c.system.programs.loaded[frame.program].program
    if isinstance(program.instructions[frame.index], ir.Prompt):
        return Diagnostic(
            NO_ANSWER,
            Severity.ERROR,
            "this PROMPT waits for an answer that nobody gives",
            Label(cause.span),
            notes=(f"asked at {now:.3f} s, after {c.system.answers_read} answers",),
            help=("script the answers in a scenario: `[prompts]`, `answers = [...]`",),
        )
    return Diagnostic(
        WAIT_NEVER_ENDS,
        Severity.ERROR,
        "this WAIT never ends: nothing that is still to happen makes it true",
        Label(cause.span),
        notes=(f"nothing changes any more from {now:.3f} s on",),
        help=("wait for a signal that the scenario turns on, or set it in the program",),
    )


def _reached(c: Context, rule: Rule, headline: str, note: str, remedy: str) -> LimitReached:
    cause = place(c)
    assert cause is not None
    return LimitReached(rule, headline, cause.span, note, remedy)
