"""Machines that fork where something outside is looked at, within the tick and the statement."""

from functools import cache

import pytest

from tests.support_programs import cans, compiled, program
from vrts.base.stack import deep_stack
from vrts.engine.futures.future import begin, command, decide, happened, tick
from vrts.engine.futures.keys import Key, Keys
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Printed, SignalChanged
from vrts.engine.memory.records import Ending
from vrts.engine.programs.outside import Kind, Question
from vrts.engine.programs.signals import INPUTS
from vrts.ir.commands import Execute
from vrts.ir.module import Module
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario

ALL = frozenset(INPUTS)


@cache
def module_of(body: str) -> Module:
    return compiled(program(body))


def started(body: str, free: frozenset[int] = ALL) -> Machine:
    machine = begin(module_of(body), robot_alone(), Scenario(), free, answers=True, random=True)
    command(machine, Execute("main"))
    return machine


def asked(machine: Machine) -> Question:
    """Go on until something is asked."""
    while machine.robot.running or machine.last_tick < 0:
        question = tick(machine)
        if question is not None:
            return question
    raise AssertionError("nothing was asked")


def ended(machine: Machine, *answers: bool | str | float) -> Machine:
    """Answer one question after the other until the program ends."""
    left = list(answers)
    while machine.robot.running or machine.last_tick < 0:
        question = tick(machine)
        if question is not None:
            decide(machine, question, left.pop(0))
    assert not left
    return machine


def value(machine: Machine, name: str) -> object:
    bound = machine.executable.layout.bound(machine.system.memory, name)
    assert bound is not None
    return bound.value


def written(machine: Machine) -> str:
    return "".join(event.text for event in happened(machine) if isinstance(event, Printed))


class Explored:
    """Every future of a program, with and without merging."""

    def __init__(self, body: str, *, merging: bool = True, most: int = 4000) -> None:
        module = module_of(body)
        machine = started(body)
        self.keys, self.seen = Keys(module), set[Key]()
        self.decisions = 0
        self.ends: list[Machine] = []
        waiting = [machine]
        while waiting:
            machine = waiting.pop()
            while True:
                question = tick(machine)
                assert len(self.seen) < most
                if question is None and not machine.robot.running:
                    self.ends.append(machine)
                    break
                key = self.keys.of(machine, question)
                if merging and key in self.seen:
                    break
                self.seen.add(key)
                if question is not None:
                    self.decisions += 1
                    other = machine.copy()
                    decide(other, question, True)
                    decide(machine, question, False)
                    waiting.append(other)

    def values(self, name: str) -> set[object]:
        return {value(machine, name) for machine in self.ends}


def test_a_statement_that_looks_at_an_undecided_input_has_not_begun() -> None:
    machine = started("n = 1\nSIGNAL 1, 2*SIG(1001)\nn = 2\n")
    assert asked(machine) == Question(Kind.INPUT, 1001)
    assert value(machine, "n") == 1.0
    finished, other = machine.finished, machine.copy()
    decide(machine, Question(Kind.INPUT, 1001), True)
    decide(other, Question(Kind.INPUT, 1001), False)
    assert tick(machine) is None
    assert tick(other) is None
    assert machine.finished == other.finished == finished + 3
    assert {s for s in machine.system.signals.on if s < 1000} == {1}, "TRUE is -1: 2 is turned off"
    assert value(machine, "n") == value(other, "n") == 2.0


def test_an_event_of_a_statement_that_begins_again_is_told_once() -> None:
    machine = ended(started("SIGNAL 1, 3*(1+SIG(1001))\n"), False)
    turned = [e.signal for e in happened(machine) if isinstance(e, SignalChanged)]
    assert turned == [1, 3]


def test_a_decision_holds_for_its_tick_only() -> None:
    body = "k = SIG(1001)\nm = SIG(1001)\nWAIT\nn = SIG(1001)\n"
    machine = ended(started(body), True, False)
    assert [value(machine, name) for name in "kmn"] == [-1.0, -1.0, 0.0]


def test_inputs_that_are_not_free_are_not_asked_about() -> None:
    machine = ended(started("n = SIG(1001)\n", frozenset({1002})))
    assert value(machine, "n") == 0.0


def test_the_limit_of_a_loop_begins_again_with_its_statement() -> None:
    machine = ended(started("i = 3\nFOR i = i+1 TO i-2*SIG(1001)\nn = i\nEND\n"), True)
    assert value(machine, "n") == 6.0, "from 4 to 4+2"


def test_random_numbers_and_answers_are_decided() -> None:
    machine = ended(started('PROMPT "how many? ", n\nx = RANDOM+RANDOM\n'), "7", 0.25, 0.5)
    assert value(machine, "n") == 7.0
    assert value(machine, "x") == 0.75
    assert written(machine) == "how many? 7\r\n"


def test_random_numbers_of_later_statements_are_asked_about_anew() -> None:
    body = "x = RANDOM*SIG(1001)\ny = RANDOM\n"
    machine = ended(started(body), 0.5, True, 0.25)
    assert value(machine, "x") == -0.5
    assert value(machine, "y") == 0.25


def test_a_statement_that_waits_draws_a_new_number_in_every_tick() -> None:
    machine = ended(started("WAIT RANDOM > 0.5\nn = RANDOM\n"), 0.25, 0.375, 0.75, 0.125)
    assert value(machine, "n") == 0.125
    assert machine.last_tick == 2


def test_programs_that_wait_beside_each_other_draw_numbers_of_their_own() -> None:
    body = "PCEXECUTE b\nWAIT RANDOM > 0.5\nWAIT SIG(2001)\n.END\n"
    body += ".PROGRAM b\nWAIT RANDOM > 0.5\nSIGNAL 2001"
    machine = started(body)
    drawn: list[str] = []
    for turns in range(8):
        while (question := tick(machine)) is not None:
            mid = machine.mid
            assert mid is not None
            drawn.append("robot" if mid.turn == 0 else "process")
            decide(machine, question, 0.75 if turns > 3 else 0.25)
    assert machine.robot.ending is Ending.COMPLETED
    assert drawn.count("robot") == drawn.count("process") > 2, "one each in every tick"


def test_a_reaction_is_asked_about_in_every_tick() -> None:
    machine = started("REACTI 1001, ends\nMOVE a\nBREAK\n.END\n.PROGRAM ends\nHALT")
    found: list[int] = []
    for _ in range(5):
        assert asked(machine) == Question(Kind.INPUT, 1001)
        found.append(machine.last_tick)
        decide(machine, Question(Kind.INPUT, 1001), False)
    assert found == list(range(found[0], found[0] + 5))
    asked(machine)
    decide(machine, Question(Kind.INPUT, 1001), True)
    assert ended(machine).robot.ending is Ending.HALTED


def test_what_nobody_looks_at_is_skipped() -> None:
    machine = started("DELAY 5\nBREAK\nn = SIG(1001)\n")
    ticks = 0
    while tick(machine) is None:
        ticks += 1
    assert machine.now >= 5.0
    assert ticks < 6


def test_a_wait_of_any_length_costs_two_branches() -> None:
    found = Explored("WAIT SIG(1001)\nn = 1\n")
    assert found.decisions == 2, "the first look, and any later one"
    assert len(found.ends) == 2
    assert found.values("n") == {1.0}


@pytest.mark.parametrize("count", [2, 4, 8, 16])
def test_inputs_read_one_behind_the_other_cost_no_more_than_their_sum(count: int) -> None:
    lines = [f"IF SIG({1001 + k}) THEN\nd = d+1\nEND" for k in range(count)]
    found = Explored("\n".join(["d = 0", *lines]))
    assert found.values("d") == {float(k) for k in range(count + 1)}
    assert found.decisions == count * (count + 1) // 2
    separate = [f"IF SIG({1001 + k}) THEN\nd = 1\nELSE\nd = 2\nEND" for k in range(count)]
    assert Explored("\n".join(separate)).decisions == 2 * count - 1


def test_merging_changes_no_answer() -> None:
    body = "n = 0\nFOR i = 1 TO 6\nIF SIG(1001) THEN\nn = n+i\nEND\nWAIT\nEND\n"
    merged, all_of_them = Explored(body), Explored(body, merging=False)
    assert merged.values("n") == all_of_them.values("n") == {float(k) for k in range(22)}
    assert merged.decisions < all_of_them.decisions == 63


@deep_stack()
def key_after(body: str, ticks: int, keys: Keys) -> Key:
    """Return the key some ticks after `n` was given a value."""
    machine, since = started(body, frozenset()), 0
    while since < ticks:
        assert tick(machine) is None
        machine.next_tick = machine.last_tick + 1
        since += value(machine, "n") == 1.0
    return keys.of(machine)


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("MOVE b", "MOVES b"),
        ("SPEED 50\nMOVE b", "SPEED 40\nMOVE b"),
        ("MOVE b\nMOVE c", "MOVE b\nMOVES c"),
    ],
)
def test_keys_tell_the_ways_of_the_arm_apart(one: str, other: str) -> None:
    begins = "MOVE a\nBREAK\nn = 1\n"
    keys = Keys(module_of(begins + one))
    assert key_after(begins + one, 8, keys) == key_after(begins + one, 8, keys)
    assert key_after(begins + one, 8, keys)[1] != key_after(begins + other, 8, keys)[1]


def test_where_the_arm_stands_tells_not_how_it_came_there() -> None:
    keys = Keys(module_of("MOVE a"))
    waits = "\nMOVE a\nBREAK\nn = 1\nWAIT SIG(2001)"
    assert key_after(f"MOVE b{waits}", 3, keys)[1:3] == key_after(f"MOVE c{waits}", 3, keys)[1:3]
    delays = "\nMOVE a\nBREAK\nn = 1\nDELAY "
    one, other = (key_after(f"MOVE b{delays}{s}", 3, keys) for s in (10, 11))
    assert one[1] != other[1], "they end at different times"


CAN = ".LOCATIONS\ngrip 800 -450 -225 90 90 0\n.END\n"


def at_a_can(body: str, *, grips: bool = True) -> Machine:
    text = f".PROGRAM main\nOPENI\nAPPRO grip, 120\nMOVES grip\n{body}\n.END\n{CAN}"
    machine = begin(compiled(text), cans(), Scenario(), ALL, grips=grips)
    command(machine, Execute("main"))
    return machine


@deep_stack()
def test_whether_a_part_is_there_is_decided_where_the_hand_would_grasp_it() -> None:
    body = "GRASP 20, 10\nn = 1\nHALT\n10 n = 2"
    machine = at_a_can(body)
    assert asked(machine) == Question(Kind.GRIP)
    other = machine.copy()
    decide(machine, Question(Kind.GRIP), True)
    decide(other, Question(Kind.GRIP), False)
    assert value(ended(machine), "n") == 1.0
    assert value(ended(other), "n") == 2.0
    assert machine.system.hand.held == "can1"
    assert other.system.hand.held is None


def test_a_hand_that_closes_on_nothing_asks_nothing() -> None:
    ended(at_a_can("DEPARTS 100\nCLOSEI\n"))
    ended(at_a_can("CLOSEI\n", grips=False))


def test_what_is_grasped_on_the_way_is_asked_about_once() -> None:
    machine = at_a_can("CLOSE\nDEPARTS 100\nBREAK\nOPENI")
    asked(machine)
    decide(machine, Question(Kind.GRIP), True)
    ended(machine)
