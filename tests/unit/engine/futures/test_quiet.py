"""Machines that share what does not change: they do what those do that share nothing."""

from functools import cache

import pytest

from tests.support_programs import compiled, program
from vrts.base.stack import deep_stack
from vrts.engine.futures import future
from vrts.engine.futures.future import begin, command, decide, happened, tick
from vrts.engine.futures.quiet import fork, let_go
from vrts.engine.machine.machine import Machine
from vrts.engine.programs.outside import Kind
from vrts.engine.programs.signals import INPUTS
from vrts.ir.commands import Execute
from vrts.ir.module import Module
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario

MOST = 40  # futures of a program
LAST = 60  # tick
ASKS = "n = 0\nx = 0\nFOR i = 1 TO 3\nIF SIG(1001) THEN\n{}\nEND\nDELAY 0.05\nEND\n"
INSIDE = {
    "a number": "x = x+1",
    "a delay": "DELAY 0.1",
    "a wait for an input": "WAIT SIG(1002)",
    "an output": "SIGNAL 1, -2",
    "a timer": "TIMER 1 = 0\nDELAY 0.1\nx = TIMER(1)",
    "a setting": "SPEED 10 ALWAYS",
    "a tool": "TOOL TRANS(0,0,i,0,0,0)",
    "a parameter": "PARAMETER HAND.TIME = 0.1*i\nCLOSEI",
    "a motion": "MOVE b\nMOVE c",
    "the hand": "CLOSEI\nOPENI",
    "the hand with the next motion": "CLOSE\nDELAY 0.1\nMOVE a",
    "text": 'TYPE "here", i',
    "an answer": 'PROMPT "how many", x',
    "a random number": "x = RANDOM",
    "an error": "x = 1/(i-2)",
    "an error that is caught": "REACTE gone\nx = 1/(i-2)",
    "a reaction": "REACT 1002, gone\nDELAY 0.1",
    "another program": "CALL gone",
    "a program beside it": "PCEXECUTE gone\nDELAY 0.1",
    "a switch": "DISABLE MESSAGES\nTYPE i",
}
GONE = ".END\n.PROGRAM gone\nn = n+1\nDELAY 0.03\nRETURN"


@cache
def module_of(body: str) -> Module:
    return compiled(program(body + GONE))


def never_quiet(machine: Machine) -> None:
    """Let a machine share nothing."""


@deep_stack()
def gone_through(body: str) -> list[object]:
    """Return what happens in all futures, one after another."""
    first = begin(
        module_of(body), robot_alone(), Scenario(), frozenset(INPUTS), answers=True, random=True
    )
    command(first, Execute("main"))
    told: list[object] = []
    left, count = [first], 1
    while left:
        machine = left.pop()
        while machine.last_tick < LAST and (machine.robot.running or machine.last_tick < 0):
            question = tick(machine)
            told.append((machine.last_tick, question, list(happened(machine)), shown(machine)))
            if question is None:
                continue
            values = {Kind.INPUT: (True, False), Kind.ANSWER: ("1", "2"), Kind.RANDOM: (0.25, 0.5)}
            first_value, second = values[question.kind]
            if count < MOST:
                count += 1
                other = fork(machine)
                decide(other, question, first_value)
                left.append(other)
            decide(machine, question, second)
        let_go(machine)
    return told


def shown(machine: Machine) -> object:
    """Return what programs have come to."""
    system = machine.system
    return (
        machine.next_tick,
        machine.robot.ending,
        [(frame.program, frame.index) for frame in machine.robot.frames],
        [cell.value for cell in system.memory.cells()],
        (sorted(set(system.signals.on)), sorted(system.timers.items()), system.scheduled[:]),
        (system.planner.settings.always, system.planner.tool, system.planner.hold_until),
        (system.planner.configuration, system.hand.strokes[-1:], system.terminal.characters),
        sorted(system.switches.items()),
        [(name, cell.value) for name, cell in system.parameters.items()],
    )


@pytest.mark.parametrize("inside", INSIDE)
def test_it_does_what_a_machine_does_that_shares_nothing(
    inside: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    body = ASKS.format(INSIDE[inside])
    shared = gone_through(body)
    monkeypatch.setattr(future, "quiet", never_quiet)
    assert gone_through(body) == shared


@deep_stack()
def test_copies_share_the_arm_until_one_of_them_changes_it() -> None:
    body = "DELAY 0.1\nDELAY 0.1\nIF SIG(1001) THEN\nSPEED 10 ALWAYS\nEND\nDELAY 0.1\n"
    machine = begin(compiled(program(body)), robot_alone(), Scenario(), frozenset(INPUTS))
    command(machine, Execute("main"))
    while (question := tick(machine)) is None:
        pass
    other = fork(machine)
    assert other.system.planner is machine.system.planner
    decide(other, question, value=True)
    tick(other)
    assert other.system.planner is not machine.system.planner
    assert other.system.planner.settings.always != machine.system.planner.settings.always


@deep_stack()
def test_a_delay_uses_up_no_settings_of_another_future() -> None:
    body = "SPEED 10\nWAIT SIG(1001)\nIF SIG(1002) THEN\nDELAY 0.1\nEND\nMOVE a\n"
    machine = begin(compiled(program(body)), robot_alone(), Scenario(), frozenset(INPUTS))
    command(machine, Execute("main"))
    comes = iter((False, False, False, True))
    while (question := tick(machine)) is None or question.number == 1001:
        if question is not None:
            decide(machine, question, value=next(comes))
    other = fork(machine)
    assert "speed" in machine.system.planner.settings.next
    decide(other, question, value=True)
    tick(other)
    assert "speed" not in other.system.planner.settings.next
    assert "speed" in machine.system.planner.settings.next
