"""Commands that change what the controller remembers: variables, programs, signals, one step."""

import pytest

from tests.support_engine import driven, lines, main, of_kind, refused
from tests.support_programs import compiled, switched
from vrts.engine.memory.events import SignalChanged
from vrts.engine.run import Run
from vrts.ir.commands import (
    DeletePrograms,
    DeleteVariables,
    Do,
    Execute,
    ForceSignals,
    Load,
    Proceed,
    SetVariable,
)
from vrts.ir.module import Module
from vrts.scene.model import FaultKind, PlannedFault, Scenario


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


def one(step: str) -> Module:
    """Return the module of the monitor's DO."""
    return compiled(f".PROGRAM do.it\n{step}\n.END\n")


def test_do_carries_one_instruction_out() -> None:
    run = driven(main("SET x = a"), 9.0, (1.0, Do(one("SIGNAL 5"))), (2.0, Do(one("MOVE x"))))
    assert switched(run)[5] == pytest.approx(1.0, abs=0.03)
    assert run.at(9.0).X_WT.translation == pytest.approx((0.9, 0.2, 0.1), abs=1e-9)


def test_do_is_refused_while_a_program_executes() -> None:
    run = driven(main("DELAY 3\nBREAK"), 5.0, (1.0, Do(one("SIGNAL 5"))))
    assert refused(run) == ["Illegal when program executing"]
    assert switched(run) == {}


def test_a_paused_program_goes_on_after_do() -> None:
    text = main("n = 1\nPAUSE\nTYPE n\nCALL sub", ".PROGRAM sub\nPAUSE\nTYPE n\n.END\n")
    run = driven(
        text,
        9.0,
        (1.0, Do(one("n = 5"))),
        (2.0, Proceed()),
        (3.0, Do(one("n = 6"))),
        (4.0, Do(one("n = n+1"))),
        (5.0, Proceed()),
    )
    assert refused(run) == []
    assert texts(run) == ["5", "7"]


def test_a_setting_given_with_do_is_for_the_next_motion() -> None:
    run = driven(main("TYPE 1"), 9.0, (1.0, Do(one("SPEED 20"))), (2.0, Do(one("DRIVE 1, 10, 50"))))
    assert run.motions[0].speed_fraction == 0.5
    run = driven(main("TYPE 1"), 9.0, (1.0, Do(one("SPEED 20"))), (2.0, Do(one("READY"))))
    assert run.motions[0].speed_fraction == pytest.approx(0.2)


def test_an_error_in_do_leaves_the_program_where_it_was() -> None:
    run = driven(main("PAUSE\nTYPE 2"), 4.0, (1.0, Do(one("TYPE 1/0"))), (2.0, Proceed()))
    assert len(run.findings) == 1
    assert texts(run) == ["2"]


def test_a_variable_may_be_set_while_a_program_waits_for_it() -> None:
    run = driven(main('go = 0\nWAIT go == 1\nTYPE "went"'), 5.0, (2.0, SetVariable("go", (), 1.0)))
    assert lines(run) == [(pytest.approx(2.0, abs=0.03), "went")]
    assert run.at(1.0).variables["go"] == 0.0


def test_variables_and_elements_can_be_set_and_forgotten() -> None:
    run = driven(
        main("m[3] = 7\nk = 1"),
        5.0,
        (1.0, SetVariable("m", (4,), 8.0)),
        (2.0, SetVariable("m", (3,), None)),
        (3.0, DeleteVariables(("m", "k"))),
    )
    assert {k: v for k, v in run.at(1.5).variables.items() if k[0] in "mk"} == {
        "m[3]": 7.0,
        "m[4]": 8.0,
        "k": 1.0,
    }
    assert "m[3]" not in run.at(2.5).variables
    assert not {"m[4]", "k"} & run.at(3.5).variables.keys()


def test_load_adds_programs_and_data_and_replaces_those_of_the_same_name() -> None:
    more = compiled('.PROGRAM sub\nTYPE "new", n\n.END\n.REALS\nn 5\n.END\n')
    text = main("CALL sub", '.PROGRAM sub\nTYPE "old"\n.END\n')
    run = driven(text, 5.0, (1.0, Load(more)), (2.0, Execute("main")), (3.0, Execute("sub")))
    assert texts(run) == ["old", "new 5", "new 5"]
    assert "n" not in run.at(0.9).variables
    assert run.at(1.5).variables["n"] == 5.0


def test_a_program_in_use_is_not_replaced() -> None:
    more = compiled(".PROGRAM main\nTYPE 1\n.END\n")
    run = driven(main("DELAY 3\nBREAK\nTYPE 2"), 5.0, (1.0, Load(more)))
    assert refused(run) == ["Illegal when program executing"]
    assert texts(run) == ["2"]


def test_programs_can_be_deleted_unless_they_are_in_use() -> None:
    text = main("PAUSE\nCALL sub", ".PROGRAM sub\nTYPE 1\n.END\n")
    run = driven(
        text,
        5.0,
        (1.0, DeletePrograms(("main",))),
        (1.5, DeletePrograms(("nosuch",))),
        (2.0, DeletePrograms(("sub",))),
        (3.0, Proceed()),
    )
    assert refused(run) == ["Program is in use", "Undefined program or variable name"]
    assert [d.rule.code for d in run.findings] == ["V255"]
    assert set(run.module.programs) == {"main"}


def test_signals_can_be_forced_inputs_too() -> None:
    run = driven(
        main('WAIT SIG(1001)\nTYPE "on"\nWAIT SIG(-1001)\nTYPE "off"'),
        5.0,
        (1.0, ForceSignals((1001, 7, 2001))),
        (2.0, ForceSignals((-1001, -7))),
        (3.0, ForceSignals((999,))),
    )
    assert [round(t) for t, _ in lines(run)] == [1, 2]
    assert run.at(4.0).signals == {2001}
    assert refused(run) == ["Illegal digital signal"]


def test_an_input_that_is_stuck_cannot_be_forced() -> None:
    stuck = Scenario(faults=(PlannedFault(1.0, FaultKind.INPUT_STUCK, 1001, on=False),))
    run = driven(main("WAIT SIG(1001)"), 4.0, (2.0, ForceSignals((1001,))), scenario=stuck)
    assert of_kind(run, SignalChanged) == []
    assert run.ending.value == "running"
