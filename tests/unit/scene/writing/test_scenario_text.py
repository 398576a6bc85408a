"""Scenarios as text: read again, they say the same."""

import math
from dataclasses import replace
from types import MappingProxyType

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support_programs import cans
from vrts.base.source import SourceFile
from vrts.ir.system import PARAMETERS
from vrts.scene.model import (
    Act,
    Deed,
    FaultKind,
    Limits,
    Parts,
    PlannedFault,
    Region,
    Scenario,
    Sensor,
)
from vrts.scene.reading.scenario_file import read_scenario
from vrts.scene.writing.scenario_text import scenario_text

SCENE = cans()
FULL = Scenario(
    configuration=(0.1, math.radians(-90), math.radians(90), 0.0, 0.2, math.pi / 7),
    hand_opening=0.08,
    seed=7,
    inputs=((0.014, 1001, True), (0.042, 1002, True), (2.0, 1001, False)),
    limits=Limits(1_000, 60.0, 20, 30, 500),
    parameters=MappingProxyType({"hand.time": 0.05}),
    sensors=(Sensor(1003, Region((0.7, -0.55, -0.3), (0.9, -0.35, -0.1)), ("can1",), True),),
    answers=("5", 'say "yes"', ""),
    faults=(
        PlannedFault(1.0, FaultKind.PART_MISSING),
        PlannedFault(2.0, FaultKind.INPUT_STUCK, 1004, on=True),
    ),
    monitor_speed=37.5,
    operator=(
        Act(1.106, Deed.STOP),
        Act(2.0, Deed.PROCEED),
        Act(3.0, Deed.STOP),
        Act(4.0, Deed.RETRY),
        Act(9.0, Deed.EXECUTE, Parts.PUT_BACK),
        Act(19.0, Deed.EXECUTE, Parts.TAKEN),
    ),
    draws=(0.0, 0.9999),
    process_first=(0.5, 1.25),
    analog=((0.0, 3, 17), (0.5, 1, -2048), (2.5, 3, 0), (2.5, 8, 2047)),
)


def read_again(scenario: Scenario) -> Scenario:
    text = scenario_text("a scenario", scenario)
    found, said = read_scenario(SourceFile("a.toml", text), SCENE, PARAMETERS)
    assert found is not None, (text, [one.headline for one in said])
    assert found.title == "a scenario"
    return found.scenario


def test_everything_that_a_scenario_says_is_read_again() -> None:
    assert read_again(FULL) == FULL


def test_what_is_as_usual_is_left_out() -> None:
    assert scenario_text("nothing", Scenario()) == 'title = "nothing"\n'
    assert read_again(Scenario()) == Scenario(hand_opening=SCENE.robot.gripper.opening_min)


@pytest.mark.parametrize("deed", list(Deed))
def test_what_an_operator_does_is_read_again(deed: Deed) -> None:
    scenario = Scenario(operator=(Act(2.5, deed),))
    assert read_again(scenario).operator == scenario.operator


@given(
    st.lists(st.tuples(st.floats(0.0, 7000.0), st.integers(1001, 1032)), max_size=6),
    st.lists(st.floats(0.0, 1.0), max_size=4),
    st.floats(0.02, 0.08),
)
def test_numbers_are_read_as_they_were_written(
    changes: list[tuple[float, int]], draws: list[float], opening: float
) -> None:
    firsts = {n: t for t, n in changes}
    inputs = tuple(sorted((t, n, True) for n, t in firsts.items()))
    scenario = replace(FULL, inputs=inputs, draws=tuple(draws), hand_opening=opening, sensors=())
    found = read_again(scenario)
    assert (found.inputs, found.draws) == (scenario.inputs, scenario.draws)
    assert found.hand_opening == pytest.approx(opening, rel=1e-12)
