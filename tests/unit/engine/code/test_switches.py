"""System switches and parameters."""

import pytest

from tests.support_engine import of_kind, runs, words
from tests.support_programs import codes
from vrts.engine.memory.events import SwitchChanged
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.scene.model import Scenario


@pytest.mark.parametrize("name", sorted(SWITCHES))
def test_every_switch_can_be_read_and_turned(name: str) -> None:
    run = runs(f"TYPE SWITCH({name})\nDISABLE {name}\nENABLE {name}\nDISABLE {name}")
    first = {True: "-1", False: "0"}[SWITCHES[name].on]
    assert run.output.split()[0] == first
    assert run.at(run.horizon_s).switches[name] is False
    changes = [e.on for e in of_kind(run, SwitchChanged) if e.switch == name]
    assert changes == ([False, True, False] if SWITCHES[name].on else [True, False])


def test_several_switches_at_once() -> None:
    run = runs("DISABLE CP, UPPER, MESSAGES\nENABLE MESSAGES, TRACE")
    switches = run.at(run.horizon_s).switches
    assert [switches[n] for n in ("CP", "UPPER", "MESSAGES", "TRACE")] == [False, False, True, True]


@pytest.mark.parametrize(("upper", "result"), [("DISABLE", "0"), ("ENABLE", "-1")])
def test_upper_compares_strings_without_case(upper: str, result: str) -> None:
    assert runs(f'{upper} UPPER\nTYPE "Part" == "PART"').output.split() == [result]


@pytest.mark.parametrize("name", sorted(PARAMETERS))
def test_every_parameter_can_be_read_and_set(name: str) -> None:
    index = "[2]" if name == "NEST.POS" else ""
    run = runs(f"PARAMETER {name}{index} = 1\nTYPE PARAMETER({name}{index})")
    assert codes(run) == []
    assert run.output.split() == ["1"]


def test_parameters_at_the_start_are_the_robots() -> None:
    run = runs(
        "TYPE PARAMETER(HAND.TIME), PARAMETER(HAND.MAX), PARAMETER(VEL.LIN), PARAMETER(TACC),"
        " PARAMETER(SPEED.MAX), PARAMETER(NEST.POS[2])"
    )
    assert [float(x) for x in run.output.split()] == [0.3, 80, 1000, 0.224, 100, -90]


def test_a_scenario_may_set_parameters() -> None:
    run = runs("TYPE PARAMETER(HAND.TIME)", scenario=Scenario(parameters={"hand.time": 0.75}))
    assert run.output.split() == ["0.75"]


def test_nest_goes_where_its_parameter_says() -> None:
    run = runs("PARAMETER NEST.POS[1] = 30\nNEST", dialect="val2+")
    assert codes(run) == []
    ready = run.scene.robot.arm.ready
    assert run.motions[0].goal == pytest.approx((0.5235988, *ready[1:]), abs=1e-6)


POWER = ["MOVE a", "READY", "DRIVE 1, 5", "OPENI", "CLOSE", "SPEED 50", "DELAY 1"]


@pytest.mark.parametrize("step", POWER)
def test_without_power_robot_instructions_are_refused(step: str) -> None:
    run = runs(f"DISABLE POWER\n{step}")
    assert words(run) == ["Robot power off"]
    assert run.motions == []
    assert codes(runs(f"DISABLE POWER\nENABLE POWER\nOPENI\n{step}")) == []


def test_turning_the_power_off_stops_the_arm() -> None:
    run = runs(
        "MOVE #PPOINT(150,-90,90,0,0,0)\nWAIT TIMER(0) > 1\nDISABLE POWER\nTYPE SWITCH(POWER)"
    )
    assert run.motions[0].cut
    assert run.output.split() == ["0"]
    assert run.ending.value == "completed"
