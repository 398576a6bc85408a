"""Analog inputs: what is tried was worked out by hand, and no count that matters is left out."""

from random import Random

import pytest

from tests.support_programs import compiled, typed
from tests.unit.prove.explore.proofs import ALONE, module_of, only, proven, wrongs
from vrts.base.stack import deep_stack
from vrts.check.verdict import Answer
from vrts.engine.controller import execute
from vrts.engine.memory.records import Ending
from vrts.prove.asking import Asking
from vrts.prove.environment.environment import Counts, Environment
from vrts.prove.explore.search import Search
from vrts.prove.proof import Proof, What, Wrong
from vrts.prove.prove import prove
from vrts.scene.model import Scenario

EVERY = "analog input 1: every count from -2048 to 2047, in every tick in which it is read"


def within(least: int, most: int, *values: int) -> Environment:
    return Environment(analog={1: Counts(least, most, values)})


def reads(proof: Proof) -> list[tuple[int, float]]:
    """Return which analog inputs had to read what for the one thing that goes wrong."""
    return [(one.number, float(one.value)) for one in only(proof).decisions]


def two(main: str, *others: str) -> str:
    """Return the lines of one program, and others behind it."""
    return f"{main}\n" + "".join(f".END\n.PROGRAM {other}\n" for other in others)


def test_an_input_reads_the_same_all_through_a_tick() -> None:
    body = "n = 0\nIF ADC(1) > 500 THEN\n{}IF ADC(1) < 400 THEN\nn = 1/n\nEND\nEND\n"
    proof = proven(body.format(""))
    assert proof.answer is Answer.HOLDS
    assert proof.covered.quantified[0] == EVERY
    assert not proof.covered.sampled
    assert reads(proven(body.format("WAIT\n"))) == [(1, 501.0), (1, 0.0)], "one tick later"


def test_a_way_that_one_count_alone_leads_is_found() -> None:
    found = only(proven("n = 0\nIF ADC(1) == 1234 THEN\nn = 1/n\nEND\n"))
    assert found.scenario.analog == ((0.0, 1, 1234),)
    body = "n = 0\nIF ADC(1) == 1234 THEN\nn = 1/n\nEND\n"
    assert execute(module_of(body), ALONE, found.scenario).ending is Ending.ERROR


def test_counts_made_volts_are_told_apart_by_what_the_volts_are_compared_with() -> None:
    volts = "n = 0\nv = ADC(1)/204.8\nIF (v > 2.5) AND (v < 2.505) THEN\nn = 1/n\nEND\n"
    assert reads(proven(volts)) == [(1, 513.0)], "512 counts are 2.5 V, and 513 2.50488 V"
    none = volts.replace("2.505", "2.504")
    assert proven(none).answer is Answer.HOLDS


def test_volts_that_are_typed_too_are_looked_at_in_every_way() -> None:
    body = "v = ADC(1)/204.8\nTYPE v\nn = 0\nIF {} > 9.99 THEN\nn = 1/n\nEND\n"
    for kept in ("v", "ADC(1)/204.8"):
        proof = proven(body.format(kept))
        assert reads(proof) == [(1, 2046.0)], "2045 counts are 9.985 V"
        assert not proof.covered.sampled
    assert proven("v = ADC(1)\nTYPE v+1\n").covered.sampled


def test_a_wait_for_a_level_costs_no_more_states_than_one_for_a_signal() -> None:
    level, signal = proven("WAIT ADC(1) > 500\nMOVE a\n"), proven("WAIT SIG(1001)\nMOVE a\n")
    assert level.answer is Answer.HOLDS
    assert level.covered.states == signal.covered.states
    assert "inputs for which a program waits come eventually" in level.covered.assumed


def test_a_wait_for_what_cannot_come_is_a_deadlock() -> None:
    assert only(proven("WAIT ADC(1) > 900\n", within(0, 800))).wrong is Wrong.DEADLOCK
    assert proven("WAIT ADC(1) > 900\n", within(0, 901)).answer is Answer.HOLDS


def test_a_level_with_two_thresholds_is_compared_in_a_loop() -> None:
    body = (
        "hot = 0\nWHILE SIG(-1001) DO\nv = ADC(1)\nIF v > 800 THEN\nhot = 1\nEND\n"
        "IF v < 600 THEN\nhot = 0\nEND\nIF (hot == 1) AND (v < {}) THEN\nv = 1/0\nEND\nWAIT\nEND\n"
    )
    right = proven(body.format(600))
    assert right.answer is Answer.HOLDS
    assert not right.covered.sampled
    assert right.covered.states < 40, "three regions, two states of `hot`, each before and after"
    assert reads(proven(body.format(601))) == [(1, 801.0), (1, 600.0)]


def test_two_inputs_go_wrong_together_only() -> None:
    proof = proven("n = 0\nIF (ADC(1) > 100) AND (ADC(2) < -100) THEN\nn = 1/n\nEND\n")
    assert reads(proof) == [(1, 101.0), (2, -101.0)]


def test_two_inputs_compared_with_each_other_are_sampled() -> None:
    proof = proven("n = 0\nIF ADC(1) > ADC(2)+4000 THEN\nn = 1/n\nEND\n")
    assert sorted(n for n, _ in reads(proof)) == [1, 2]
    assert [line[:32] for line in proof.covered.sampled] == [
        "analog input 1, -2048 to 2047: -",
        "analog input 2, -2048 to 2047: -",
    ]


def test_a_count_that_moves_the_arm_is_sampled_at_ends_and_between() -> None:
    proof = proven("MOVE SHIFT(a BY ADC(1)/10,0,0)\n", within(0, 1000))
    assert proof.answer is Answer.HOLDS
    assert proof.covered.sampled[0] == "analog input 1, 0 to 1000: 0, 500, 1000 only"
    assert not [line for line in proof.covered.quantified if "analog" in line]


def test_a_count_without_bounds_of_its_own_is_tried_as_far_as_a_controller_reads() -> None:
    proof = proven("MOVE SHIFT(a BY ADC(1),0,0)\n")
    assert proof.answer is Answer.VIOLATED
    assert {one.scenario.analog for one in proof.found} == {((0.0, 1, 1023),), ((0.0, 1, -2048),)}


def test_the_program_may_bound_it() -> None:
    body = "x = ADC(1)\nIF x > 50 THEN\nx = 50\nEND\nIF x < 0 THEN\nx = 0\nEND\n"
    proof = proven(f"{body}MOVE SHIFT(a BY x,0,0)\n")
    assert proof.answer is Answer.HOLDS
    tried = proof.covered.sampled[0].partition(": ")[2]
    assert {"-2048", "-1", "0", "1", "49", "50", "51", "2047"} <= set(tried[:-5].split(", "))


def test_a_sum_of_counts_grows_without_bound() -> None:
    body = "t = 0\nWHILE SIG(-1001) DO\nt = t+ADC(1)\nIF t > 100 THEN\nSIGNAL 1\nEND\nWAIT\nEND\n"
    proof = proven(body, within(0, 9))
    assert proof.answer is Answer.UNDETERMINED
    assert [one.name for one in proof.unbounded] == ["t"]


def test_few_counts_are_all_tried_whatever_is_done_with_them() -> None:
    proof = proven("k = 7-ADC(1)\nn = 1/k\n", within(0, 9))
    assert reads(proof) == [(1, 7.0)]
    assert not proof.covered.sampled


def test_what_may_not_read_zero_is_told_from_its_first_reading_on() -> None:
    zero = proven("n = 0\nIF ADC(1) == 0 THEN\nn = 1/n\nEND\n", within(100, 300, 100, 300))
    assert zero.answer is Answer.HOLDS
    assert zero.covered.quantified[0].startswith("analog input 1: each of 100, 300, in every tick")
    low = proven("WAIT\nv = ADC(1)\nn = 0\nIF SIG(1001) THEN\nn = 1/n\nEND\n", within(100, 300))
    assert [(d.what, d.value) for d in only(low).decisions] == [
        (What.ANALOG, 100.0),
        (What.INPUT, True),
    ]


def test_a_reaction_looks() -> None:
    body = two(
        "n = 0\nREACT 1001, gone\nMOVE a\nMOVE b", "gone()\nIF ADC(1) < -7 THEN\nn = 1/n\nEND"
    )
    found = only(proven(body))
    assert [(one.what, one.value) for one in found.decisions] == [
        (What.INPUT, True),
        (What.ANALOG, -8.0),
    ]


def test_the_other_program_looks() -> None:
    body = two("PCEXECUTE beside\nMOVE a\nMOVE b", "beside()\nWAIT ADC(3) > 20\nn = 0\nn = 1/n")
    assert reads(proven(body)) == [(3, 21.0)]


def test_an_input_whose_number_is_computed_is_sampled() -> None:
    proof = proven("FOR i = 1 TO 2\nx[i] = ADC(i)\nEND\nn = 0\nIF x[2] == 30 THEN\nn = 1/n\nEND\n")
    assert reads(proof) == [(2, 30.0)], "a number that the program knows is tried"
    assert len([line for line in proof.covered.sampled if "analog" in line]) == 2


def test_an_input_of_a_case_is_looked_at_in_every_way() -> None:
    body = "n = 0\nCASE INT(ADC(1)/1000) OF\nVALUE 0,1,2:\nVALUE -1:\nANY\nn = 1/n\nEND\n"
    proof = proven(body)
    assert reads(proof) == [(1, -2000.0)]
    assert proof.covered.quantified[0] == EVERY


def test_what_a_scenario_says_is_the_same_in_every_future() -> None:
    usual = Environment(scenario=Scenario(analog=((0.0, 1, 100), (1.0, 1, 600))))
    proof = proven("WAIT ADC(1) > 500\nn = 0\nn = 1/n\n", usual)
    assert only(proof).decisions == ()
    assert only(proof).time_s == pytest.approx(1.0, abs=0.03)
    assert not [line for line in proof.covered.quantified if "analog" in line]


def test_a_division_by_a_count_is_looked_at_where_it_fails() -> None:
    assert wrongs(proven("TYPE 1/(ADC(1)-77)\n")) == [(Wrong.ERROR, 1)]
    assert proven("TYPE ADC(1)\nMOVE a\n").covered.decisions == 1


# --- by another route -----------------------------------------------------------------------------


def asking(draw: Random) -> str:
    """Return a program that types what it made of an analog input."""
    lines: list[str] = []
    for k in range(draw.randint(1, 3)):
        scaled = draw.choice(("ADC(1)", "ADC(1)/204.8", "ABS(ADC(1))-300", "INT(ADC(1)/512)"))
        number = draw.choice((0, 1, 2.5, -3, 100, 511, -2048, 2047))
        test = draw.choice((">", "<", "==", "<>", ">=", "<="))
        kept = draw.random() < 0.5
        if kept:
            lines.append(f"v{k} = {scaled}")
        what = f"v{k}" if kept else scaled
        lines += [f"IF {what} {test} {number} THEN", f'TYPE "{k}"', f"SIGNAL {k + 1}", "END"]
    return ".PROGRAM main\n" + "\n".join(lines) + "\n.END\n"


@deep_stack()
@pytest.mark.parametrize("number", range(12))
def test_every_count_does_what_one_that_is_tried_does(number: int) -> None:
    draw = Random(f"counts {number}")
    module = compiled(asking(draw))
    search = Search(module, ALONE, Environment(), collisions=False)
    search.begin("main")
    search.go_on(Asking())
    assert search.is_over
    tried = search.outside.readings.known(1)
    assert not tried.sampled
    known = {said(module, round(count)) for count in tried.counts}
    assert len(known) <= len(tried.counts)
    some = {-2048, 2047, *(draw.randint(-2048, 2047) for _ in range(20)), *range(505, 515)}
    assert {said(module, count) for count in some} <= known


def said(module: object, count: int) -> tuple[str, ...]:
    run = execute(module, ALONE, Scenario(analog=((0.0, 1, count),)))  # type: ignore[arg-type]
    return tuple(typed(run))


def test_an_analog_input_that_there_is_not_is_an_error_whatever_comes() -> None:
    assert (
        prove(module_of("n = ADC(9)\n"), ALONE, Environment(), entry="main").found[0].decisions
        == ()
    )
