"""What depends on the future or on the past: grips that come about or not, supports, parting."""

import pytest

from tests.property.test_futures import Told
from tests.support_certify import Driven, differences, driven
from tests.support_programs import cans, compiled
from vrts.base.stack import deep_stack
from vrts.engine.controller import execute
from vrts.engine.futures.future import begin, command, happened, tick
from vrts.ir.commands import Execute, TimedCommand
from vrts.ir.module import Module
from vrts.prove.certify.certifier import Certifier
from vrts.prove.certify.looking import New, looked_at
from vrts.prove.certify.memory import LettingGo, Memory
from vrts.prove.certify.touching import Beyond, Hope, Touching, Unless
from vrts.scene.model import Scenario

SCENE = cans()
PLACES = """can 800 -450 -225 90 90 0
beside 800 -449.3 -225 90 90 0
put 950 -130 -75 90 90 0
over 750 450 -60 90 90 0
upon 750 450 -110 90 90 0
under 750 450 -215 90 90 0
edge 1012 -130 20 90 90 0
inside 1030 -130 -140 90 90 0
wall 1039.5 -130 -140 90 90 0
pressed 950 -130 -75.7 90 90 0
deep 950 -130 -77 90 90 0
aside 950 60 -150 90 90 0
"""
FETCH = "OPENI\nAPPRO can, 100\nMOVES can\nCLOSEI\nDEPARTS 250\n"


def module_of(body: str) -> Module:
    """Return a program with its places, and one that a reaction takes."""
    text = f".PROGRAM main\n{body}\n.END\n.PROGRAM away\nBRAKE\nOPENI\nDEPARTS 100\nHALT\n.END\n"
    return compiled(text + f".LOCATIONS\n{PLACES}.END\n")


@deep_stack()
def future(
    body: str, on_s: float | None = None, certifier: Certifier | None = None, first: int = 0
) -> Driven:
    """Drive a program through a certifier; input 1001 is on from a time on."""
    inputs = () if on_s is None else ((on_s, 1001, True),)
    told = Told(module_of(body), SCENE, Scenario(inputs=inputs), frozenset({1001}))
    return driven(certifier or Certifier(SCENE), told.ticks(), first)


def names(touching: list[Touching]) -> set[tuple[str, str]]:
    """Return which bodies touch."""
    return {(one.first, one.second) for one in touching}


def hopes(told: Driven) -> set[Unless | None]:
    """Return what touches hope for."""
    return {one.unless for one in told.touching}


def test_a_pad_may_press_into_what_the_closing_hand_will_grasp() -> None:
    told = future("OPENI\nAPPRO beside, 100\nMOVES beside\nCLOSEI\nDEPARTS 250\n")
    assert hopes(told) == {Unless(Hope.GRASPED, "can1")}
    assert not told.contacts
    assert [one.body for _, one in told.outcomes if one.hope is Hope.GRASPED] == ["can1"]


@pytest.mark.parametrize("late", [False, True])
def test_a_pad_may_not_press_if_the_hand_opens_again_before_it_grasps(*, late: bool) -> None:
    """Whichever future was certified first, the touch is told of the one that grasps nothing."""
    body = "OPENI\nAPPRO beside, 100\nMOVES beside\nREACTI 1001, away\nCLOSEI\nDEPARTS 250\n"
    certifier = Certifier(SCENE)
    known = future(body, None, certifier)
    (closed,) = [one.time_s for _, one in known.outcomes]
    if late:
        touched = min(one.time_s for one in known.touching)
        told = future(body, touched + 0.002, certifier, 1000)
        (outcome,) = [one for _, one in told.outcomes if one.hope is Hope.GRASPED]
        assert outcome.body == (None if touched + 0.03 < closed else "can1")
        assert all(one.future >= 1000 for one in told.touching)
    else:
        told = future(body, closed - 0.2, certifier, 1000)
        assert not told.contacts


def test_what_is_pressed_on_its_support_to_be_is_no_contact() -> None:
    told = future(FETCH + "APPRO pressed, 100\nMOVES pressed\nOPENI\nDEPARTS 100\n")
    assert hopes(told) == {Unless(Hope.SET_DOWN, "can1", "base1")}
    assert not told.contacts


def test_what_is_pressed_and_taken_away_again_is_a_contact_in_that_future() -> None:
    body = FETCH + "APPRO pressed, 100\nMOVES pressed\nBREAK\n"
    body += "IF SIG(1001) THEN\nDEPARTS 100\nMOVE aside\nEND\nOPENI\nDEPARTS 100\n"
    certifier = Certifier(SCENE)
    lets_go, carries_on = future(body, None, certifier), future(body, 0.0, certifier, 1000)
    assert not lets_go.contacts
    assert lets_go.touching
    assert ("robot", "base1") in names(carries_on.contacts)
    assert min(one.future for one in carries_on.contacts) >= 1000
    assert hopes(carries_on) >= {Unless(Hope.SET_DOWN, "can1", "base1")}


class Late(Certifier):
    """Tells of motion only when more of it is to be certified."""

    taken: New | None = None

    def certify(self) -> tuple[list[Touching], list[Beyond]]:
        """Tell what touches in the motion before."""
        told: tuple[list[Touching], list[Beyond]] = ([], [])
        if self.taken is not None:
            told = self.certified(self.taken, looked_at(self.taken))
        self.taken = self.take()
        return told


@pytest.mark.parametrize("on_s", [None, 0.0])
def test_futures_that_come_while_motion_is_certified_are_told_all_the_same(
    on_s: float | None,
) -> None:
    body = FETCH + "APPRO pressed, 100\nMOVES pressed\nBREAK\n"
    body += "IF SIG(1001) THEN\nDEPARTS 100\nMOVE aside\nEND\nOPENI\nDEPARTS 100\n"
    found: list[list[Touching]] = []
    for certifier in (Certifier(SCENE), Late(SCENE)):
        told = [future(body, on, certifier, 1000 * k) for k, on in enumerate((None, on_s, None))]
        found.append([one for it in told for one in it.touching] + certifier.certify()[0])
    assert sorted(map(repr, found[1])) == sorted(map(repr, found[0]))
    assert {one.future // 1000 for one in found[0]} == {0, 1, 2}


def test_what_is_held_when_the_future_ends_was_not_set_down() -> None:
    told = future(FETCH + "APPRO pressed, 100\nMOVES pressed\n")
    assert names(told.contacts) == {("robot", "base1")}


def test_what_is_pressed_too_deep_is_a_contact_whatever_follows() -> None:
    told = future(FETCH + "APPRO deep, 100\nMOVES deep\nOPENI\nDEPARTS 100\n")
    assert None in hopes(told)
    assert ("robot", "base1") in names(told.contacts)


def test_a_can_leaves_the_table_that_it_stood_on() -> None:
    assert not future(FETCH).touching


def test_fingers_count_again_once_they_came_free() -> None:
    body = FETCH + "APPRO put, 100\nMOVES put\nOPENI\nDRAW 0, 5, 0\n"
    assert not names(future(body).contacts) & {("robot", "can1")}
    told = future(FETCH + "APPRO put, 100\nMOVES put\nOPENI\nDRAW 0, 10.5, 0\n")
    assert ("robot", "can1") in names(told.contacts)


def test_fingers_that_never_came_free_go_on_pressing() -> None:
    told = future(FETCH + "APPRO put, 100\nMOVES put\nRELAXI\nDELAY 1\nDEPARTS 100\n")
    assert ("robot", "can1") not in names(told.touching)
    waiting = future(FETCH + "APPRO put, 100\nMOVES put\nRELAXI\nDELAY 1\n").memory
    assert {(one.body, one.finger) for one in waiting.letting_go} == {("can1", 0), ("can1", 1)}


STACKED = FETCH + "APPRO over, 60\nMOVES upon\nOPENI\nDEPARTS 100\n"
STORIES = {
    "carried with what it stands on": STACKED + "MOVES under\nCLOSEI\nDEPARTS 60\nOPENI\n",
    "dropped on another": FETCH + "APPRO over, 60\nOPENI\nDEPARTS 100\n",
    "dropped on an edge": FETCH + "MOVE edge\nOPENI\nDELAY 0.5\n",
    "dropped on the way": FETCH + "OPEN\nMOVE over\n",
    "let go within another": FETCH + "MOVE inside\nOPENI\nDELAY 0.5\n",
    "let go in a wall": FETCH + "MOVE wall\nOPENI\nDELAY 0.5\n",
    "grasped on the way": "OPENI\nAPPRO can, 100\nSPEED 20\nMOVES can\nCLOSE\nDEPARTS 90\n",
    "let go and taken again": "OPENI\nMOVE can\nCLOSEI\nRELAXI\nCLOSEI\nDEPARTS 50\nOPENI\n",
}


@pytest.mark.parametrize("story", STORIES)
@deep_stack()
def test_stories_are_told_as_the_check_of_the_run_tells_them(story: str) -> None:
    run = execute(module_of(STORIES[story]), SCENE)
    assert not differences(SCENE, run, future(STORIES[story]).contacts)


def test_what_rules_remember_is_told_from_now_on() -> None:
    machine = begin(compiled(".PROGRAM main\nDELAY 1\n.END\n"), SCENE, Scenario())
    command(machine, Execute("main"))
    tick(machine)
    one = Memory(letting_go=(LettingGo("can1", 0, -0.004),))
    same = Memory(letting_go=(LettingGo("can1", 0, -0.004 - 3 * 0.014),))
    other = Memory(letting_go=(LettingGo("can1", 0, -0.005),))
    assert one.state(machine) == same.state(machine) != other.state(machine)
    assert Memory(stood_on=(("can1", "table"),)).state(machine) != Memory().state(machine)


@deep_stack()
def test_what_the_hand_did_in_the_tick_under_way_is_remembered() -> None:
    machine = begin(compiled(".PROGRAM main\nOPENI\n.END\n"), SCENE, Scenario())
    command(machine, Execute("main"))
    before = Memory().state(machine)
    while not machine.system.hand.strokes:
        tick(machine)
    assert Memory().state(machine) != before
    happened(machine)
    assert Memory().state(machine) == before


def test_a_tick_that_was_not_to_come_is_noticed() -> None:
    machine = begin(compiled(".PROGRAM main\nDELAY 2\n.END\n"), SCENE, Scenario())
    command(machine, Execute("main"))
    tick(machine)
    certifier = Certifier(SCENE)
    memory = certifier.follow(Memory(), machine, happened(machine), 0)
    tick(machine)
    early, late = memory._replace(seen_s=machine.now + 1.0), memory._replace(seen_s=0.0)
    for wrong in (early, late):
        with pytest.raises(ValueError, match="another tick"):
            certifier.follow(wrong, machine, happened(machine), 1)
    assert certifier.follow(memory, machine, happened(machine), 1).seen_s >= machine.now


@deep_stack()
def test_a_program_that_ended_is_executed_again_before_anything_else_happens() -> None:
    """The input that comes much later would have let the ticks between be skipped."""
    scenario = Scenario(inputs=((20.0, 1002, True),))
    machine = begin(module_of("MOVE can\nHALT\n"), SCENE, scenario)
    command(machine, Execute("main"))
    certifier, memory = Certifier(SCENE), Memory()
    for _ in range(2):
        while machine.robot.running or machine.next_command_s is not None:
            tick(machine)
            memory = certifier.follow(memory, machine, happened(machine), 0)
        assert memory.seen_s == machine.now < 19.0
        at_s = (machine.ended_s or 0.0) + 4.0
        machine.issue((TimedCommand(at_s, Execute("main")),))
        machine.next_tick = machine.last_tick + 1
    assert machine.now > 4.0
