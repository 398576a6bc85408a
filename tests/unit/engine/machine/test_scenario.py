"""What happens to a run from outside: inputs, faults, sensors, the start."""

import pytest

from tests.support_engine import TACC, TICK, driven, lines, main, of_kind, refused, runs, words
from tests.support_programs import cans, compiled, ended, ran, switched
from vrts.engine.controller import execute
from vrts.engine.memory.events import Released, SignalChanged, SwitchChanged
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.commands import Do, Execute
from vrts.scene.model import FaultKind, PlannedFault, Region, Scenario, Sensor

SCENE = cans()
PICK = "OPENI\nAPPRO grip, 120\nMOVES grip\nCLOSEI\nSIGNAL 1\nDEPARTS 200\nBREAK\nMOVE air\nBREAK\n"
PLACES = ".LOCATIONS\ngrip 800 -450 -225 90 90 0\nair 900 -300 0 90 90 0\n.END\n"
TABLE = Region((0.7, -0.55, -0.31), (0.9, -0.35, -0.1))  # where can1 stands


def picked(scenario: Scenario, body: str = PICK) -> Run:
    return ran(f".PROGRAM main\n{body}\n.END\n{PLACES}", SCENE, scenario)


def changes(run: Run, signal: int) -> list[tuple[float, bool]]:
    return [(e.time_s, e.on) for e in of_kind(run, SignalChanged) if e.signal == signal]


def test_inputs_change_at_the_tick_that_follows() -> None:
    inputs = ((0.5, 1001, True), (0.71, 1001, False), (0.71, 1002, True))
    run = runs("WAIT TIMER(0) > 1", scenario=Scenario(inputs=inputs))
    assert changes(run, 1001) == [
        (pytest.approx(18 * TICK), True),
        (pytest.approx(26 * TICK), False),
    ]
    assert changes(run, 1002) == [(pytest.approx(26 * TICK), True)]
    assert run.at(0.6).signals == {1001}


def test_an_input_at_the_start_is_on_for_the_first_step() -> None:
    assert (
        runs("TYPE SIG(1001)", scenario=Scenario(inputs=((0.0, 1001, True),))).output == " -1\r\n"
    )


def test_an_input_that_sticks_changes_no_more() -> None:
    scenario = Scenario(
        inputs=((0.5, 1001, True), (2.0, 1001, False)),
        faults=(PlannedFault(1.0, FaultKind.INPUT_STUCK, 1001, on=True),),
    )
    run = runs("WAIT TIMER(0) > 3\nTYPE SIG(1001)", scenario=scenario)
    assert [on for _, on in changes(run, 1001)] == [True]
    assert lines(run)[0][1] == "-1"


def test_an_input_may_stick_in_the_other_state() -> None:
    scenario = Scenario(
        inputs=((0.5, 1001, True),),
        faults=(PlannedFault(1.0, FaultKind.INPUT_STUCK, 1001, on=False),),
    )
    run = runs("WAIT TIMER(0) > 3", scenario=scenario)
    assert [(round(t, 1), on) for t, on in changes(run, 1001)] == [(0.5, True), (1.0, False)]


def test_the_gripper_slips() -> None:
    whole = picked(Scenario())
    assert whole.at(whole.horizon_s).held == "can1"
    at = ended(whole)[-1] - 0.3
    run = picked(Scenario(faults=(PlannedFault(at, FaultKind.GRIPPER_SLIPS),)))
    assert run.at(at - TICK).held == "can1"
    assert run.at(run.horizon_s).held is None
    (released,) = of_kind(run, Released)
    assert released.body == "can1"
    assert released.time_s == pytest.approx(at, abs=TICK)
    assert ended(run) == pytest.approx(ended(whole))


def test_an_emergency_stop_ends_the_program_and_slows_the_arm_down() -> None:
    stop = PlannedFault(1.0, FaultKind.EMERGENCY_STOP)
    run = runs("MOVE #PPOINT(150,-90,90,0,0,0)\nBREAK\nTYPE 1", scenario=Scenario(faults=(stop,)))
    assert words(run) == ["Robot power off"]
    assert run.ending is Ending.ERROR
    assert run.motions[0].cut
    assert run.motions[0].end_s == pytest.approx(1.0 + TACC, abs=TICK)
    (switch,) = of_kind(run, SwitchChanged)
    assert (switch.switch, switch.on) == ("POWER", False)
    assert lines(run) == []


def test_after_an_emergency_stop_the_power_has_to_be_turned_on() -> None:
    power = compiled(".PROGRAM do.it\nENABLE POWER\n.END\n")
    run = driven(
        main("TYPE 1\nREADY\nDELAY 2\nBREAK\nTYPE 2"),
        12.0,
        (2.0, Execute("main")),
        (3.0, Do(power)),
        (4.0, Execute("main")),
        scenario=Scenario(faults=(PlannedFault(1.0, FaultKind.EMERGENCY_STOP),)),
    )
    assert words(run) == ["Robot power off"] * 2
    assert refused(run) == []
    assert [text for _, text in lines(run)] == ["1", "1", "1", "2"]


def test_an_emergency_stop_is_not_caught() -> None:
    stop = PlannedFault(1.0, FaultKind.EMERGENCY_STOP)
    run = runs(
        "REACTE mend\nDELAY 3\nBREAK",
        ".PROGRAM mend\nRETURNE\n.END\n",
        Scenario(faults=(stop,)),
    )
    assert run.ending is Ending.ERROR


def test_a_sensor_sees_a_body_until_it_is_carried_away() -> None:
    run = picked(Scenario(sensors=(Sensor(1010, TABLE, ("can1",)),)))
    (first, on), (last, off) = changes(run, 1010)
    assert (first, on, off) == (0.0, True, False)
    assert last > switched(run)[1]
    z = run.at(last).poses["can1"].translation[2]
    assert run.at(last - TICK).poses["can1"].translation[2] < z


def test_a_sensor_may_be_inverted_and_may_see_the_tool() -> None:
    run = picked(
        Scenario(
            sensors=(
                Sensor(1010, TABLE, ("can1",), inverted=True),
                Sensor(1011, TABLE, ("tool",)),
            )
        )
    )
    assert [on for _, on in changes(run, 1010)] == [True]
    tool = changes(run, 1011)
    assert [on for _, on in tool] == [True, False]
    assert tool[0][0] < switched(run)[1] < tool[1][0]


def test_a_program_may_wait_for_a_sensor() -> None:
    body = PICK.replace("BREAK\nMOVE air", 'WAIT SIG(-1010)\nTYPE "gone"\nMOVE air')
    run = picked(Scenario(sensors=(Sensor(1010, TABLE, ("can1",)),)), body)
    assert lines(run)[0][1] == "gone"
    assert lines(run)[0][0] == pytest.approx(changes(run, 1010)[-1][0], abs=TICK)


def test_the_start_may_be_chosen() -> None:
    start = (0.1, -1.2, 1.0, 0.2, 0.3, 0.4)
    run = runs(
        "SET #p = #HERE\nDRIVE 1, 10", scenario=Scenario(configuration=start, hand_opening=0.03)
    )
    assert run.at(0.0).configuration == start
    assert run.at(0.0).hand_opening == 0.03
    assert run.motions[0].start == start


def test_random_numbers_follow_the_seed() -> None:
    body = "FOR i = 1 TO 20\nTYPE /F0.6, RANDOM\nEND"
    first, again, other = (runs(body, scenario=Scenario(seed=k)).output for k in (1, 1, 2))
    assert first == again != other
    assert all(0.0 <= float(x) < 1.0 for x in (first + other).split())


def test_runs_are_the_same_whenever_they_are_made() -> None:
    module = compiled(main("TYPE TIMER(3)\nMOVE a\nTYPE RANDOM, TIMER(0)"))
    assert execute(module, SCENE).events == execute(module, SCENE).events
    assert not execute(module, SCENE).findings
