"""Signals, timers and analog outputs, tick by tick."""

import pytest

from tests.support_engine import TICK, lines, of_kind, runs, words
from tests.support_programs import program, ran, switched, typed
from vrts.engine.memory.events import AnalogChanged, Found, SignalChanged
from vrts.scene.model import Scenario


def test_a_signal_that_is_on_does_not_change_again() -> None:
    run = runs("SIGNAL 1\nSIGNAL 1, 2\nSIGNAL -3\nSIGNAL -1")
    assert [(e.signal, e.on) for e in of_kind(run, SignalChanged)] == [
        (1, True),
        (2, True),
        (1, False),
    ]


def test_every_change_names_its_step() -> None:
    run = runs("SIGNAL 1\nBITS 2, 2 = 3\nRESET")
    steps = [e.cause.step for e in of_kind(run, SignalChanged) if e.cause is not None]
    assert steps == [1, 2, 2, 3, 3, 3]


def test_bits_reads_back_what_it_wrote() -> None:
    run = runs("FOR n = 0 TO 255\nBITS 9, 8 = n\nIF BITS(9,8) <> n THEN\nTYPE n\nEND\nEND\nTYPE 1")
    assert typed(run) == ["1"]


def test_timers_count_simulated_time() -> None:
    run = runs(
        "TIMER 3 = 0\nDELAY 1\nBREAK\nTYPE /F0.3, TIMER(3)\nTIMER 3 = 10\nTYPE /F0.3, TIMER(3)"
    )
    first, second = (float(text) for text in typed(run))
    assert first == pytest.approx(36 * TICK, abs=1e-3)
    assert second == 10.0


def test_timer_zero_counts_from_the_start_and_one_never_set_reads_the_same() -> None:
    run = runs("WAIT TIMER(0) >= 2\nTYPE /F0.4, TIMER(0)\nTYPE /F0.4, TIMER(7)")
    zero, seven = typed(run)
    assert zero == seven
    assert float(zero) == pytest.approx(2.0, abs=TICK)


@pytest.mark.parametrize("number", [0, 16, -1])
def test_timers_that_can_be_set_are_1_to_15(number: int) -> None:
    assert words(runs(f"n = {number}\nTIMER n = 0")) == ["Illegal value"]


def test_analog_outputs_are_events() -> None:
    run = runs("DAC 1 = 100\nWAIT\nDAC 4 = -2048\nDAC 1 = 2047.4")
    found = [(e.channel, e.value) for e in of_kind(run, AnalogChanged)]
    assert found == [(1, 100.0), (4, -2048.0), (1, 2047.0)]
    assert run.at(0.0).analog == {1: 100.0}
    assert run.at(run.horizon_s).analog == {1: 2047.0, 4: -2048.0}


@pytest.mark.parametrize("step", ["DAC 5 = 0", "DAC 0 = 0", "DAC 1 = 2048", "DAC 1 = -2049"])
def test_analog_outputs_have_limits(step: str) -> None:
    assert words(runs(step)) == ["Illegal value"]


def test_analog_inputs_read_zero() -> None:
    assert typed(runs("TYPE ADC(1), ADC(8)")) == ["0 0"]


def test_analog_inputs_read_what_a_scenario_says() -> None:
    scenario = Scenario(analog=((0.0, 2, -5), (1.0, 2, 700), (2.0, 2, 3)))
    body = 'TYPE ADC(2)\nWAIT ADC(2) > 500\nTYPE ADC(2), " ", TIMER(0)\nWAIT ADC(2) < 500\n'
    first, second, third = typed(ran(program(f"{body}TYPE ADC(2,3)"), scenario=scenario))
    assert (first, third) == ("-5", "3")
    counts, at = second.split()
    assert (counts, 1.0 <= float(at) < 1.0 + 2 * TICK) == ("700", True)


def test_a_wait_that_no_analog_input_ends_is_told_once_none_changes_any_more() -> None:
    run = ran(program("WAIT ADC(1) > 500"), scenario=Scenario(analog=((2.0, 1, 400),)))
    (found,) = of_kind(run, Found)
    assert found.diagnostic.headline.startswith("this WAIT never ends")
    assert 2.0 <= found.time_s <= 2.0 + 2 * TICK


@pytest.mark.parametrize(
    ("condition", "at"),
    [("TIMER(0) > 1", 1.0), ("SIG(3)", 0.5), ("x == 4", 1.5), ("SIG(3) AND (x == 4)", 1.5)],
)
def test_wait_goes_on_at_the_first_tick_at_which_it_is_true(condition: str, at: float) -> None:
    run = runs(
        f'x = 0\nPCEXECUTE watch\nWAIT {condition}\nTYPE "now"',
        ".PROGRAM watch\nWAIT TIMER(0) > 0.5\nSIGNAL 3\nWAIT TIMER(0) > 1.5\nx = 4\n.END\n",
    )
    (when, _) = lines(run)[0]
    assert at < when <= at + 2 * TICK


def test_a_wait_that_is_true_takes_no_time() -> None:
    assert switched(runs("SIGNAL 1\nWAIT SIG(1)\nSIGNAL 2")) == {1: 0.0, 2: 0.0}


def test_pulses_and_delayed_signals_of_as() -> None:
    run = runs("PULSE 1, 0.5\nDLYSIG 2, 1\nDLYSIG -1, 2\nTWAIT 3", dialect="as")
    found = [(round(e.time_s, 1), e.signal, e.on) for e in of_kind(run, SignalChanged)]
    assert found == [(0.0, 1, True), (0.5, 1, False), (1.0, 2, True)]
    assert run.ended_s == pytest.approx(3.0, abs=2 * TICK)
