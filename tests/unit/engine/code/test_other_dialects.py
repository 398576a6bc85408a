"""What VAL, V+ and AS have and VAL-II has not, or has otherwise."""

import pytest

from tests.support_engine import lines, runs, words
from tests.support_programs import codes
from vrts.engine.run import Run
from vrts.scene.model import Scenario

START = "JMOVE #PPOINT(0,-45,135,0,60,0)\nBREAK\n"  # for AS, away from singular places


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


def test_return_of_val_may_skip_steps() -> None:
    sub = ".PROGRAM p\nRETURN {}\n.END\n"
    body = "GOSUB p\nTYPE one\nTYPE two"
    for skip, left in (("", ["one", "two"]), ("1", ["two"]), ("2", []), ("5", [])):
        assert texts(runs(body, sub.format(skip), dialect="val")) == left


def test_moves_of_as() -> None:
    run = runs(
        START + "POINT p = SHIFT(HERE BY 50,0,-50)\nLMOVE p\nLAPPRO p, 20\nJDEPART 10\nBREAK\n"
        "TYPE /F0.1, DISTANCE(HERE,p)",
        dialect="as",
    )
    assert codes(run) == []
    assert texts(run) == ["30.0"]


def test_draw_of_as_turns_and_has_a_speed() -> None:
    run = runs(
        START + "POINT p = HERE\nDRAW 10,20,30,0,0,20,50\nBREAK\n"
        'TYPE /F0.1, DX(HERE)-DX(p), " ", DY(HERE)-DY(p), " ", DZ(HERE)-DZ(p)',
        dialect="as",
    )
    assert texts(run) == ["10.0 20.0 30.0"]
    assert run.motions[-1].speed_fraction == pytest.approx(0.05)


def test_tdraw_of_as_goes_along_the_tool() -> None:
    run = runs(START + "POINT p = HERE\nTDRAW ,,40\nBREAK\nTYPE /F0.1, DZ(-p+HERE)", dialect="as")
    assert texts(run) == ["40.0"]


def test_base_of_v_plus_and_as_is_a_frame() -> None:
    run = runs("POINT f = TRANS(100,0,0)\nBASE f\nTYPE /I0, DX(HERE)", dialect="as")
    assert texts(run) == ["-100"]


def test_speed_of_v_plus_has_a_part_for_turning() -> None:
    body = "MOVE #PPOINT(0,-45,135,0,60,0)\nBREAK\nSET p = HERE:RZ(40)\n{}MOVES p"
    times: list[float] = []
    for speed in ("SPEED 100, 100\n", "SPEED 100, 20\n"):
        run = runs(body.format(speed), dialect="val2+")
        assert codes(run) == []
        times.append(run.motions[1].end_s - run.motions[1].start_s)
    assert times[1] - times[0] == pytest.approx(40 / 20 - 2 * 0.224, abs=0.06)


def test_exit_and_next_of_v_plus() -> None:
    body = "FOR i = 1 TO 5\nIF i == 2 THEN\nNEXT\nEND\nIF i == 4 THEN\nEXIT\nEND\nTYPE i\nEND"
    assert texts(runs(body, dialect="vplus")) == ["1", "3"]


def test_wait_event_of_v_plus_waits_for_a_time() -> None:
    run = runs("WAIT.EVENT , 2\nTYPE TIMER(0) >= 2", dialect="vplus")
    assert texts(run) == ["-1"]


def test_reaction_of_as_lets_the_motion_be_completed() -> None:
    sub = ".PROGRAM sub\nTYPE TIMER(0)\n.END\n"
    run = runs(
        "ON 1003 CALL sub\nJMOVE #PPOINT(60,-90,90)\nBREAK\nTWAIT 1",
        sub,
        Scenario(inputs=((0.3, 1003, True),)),
        dialect="as",
    )
    assert codes(run) == []
    assert lines(run)[0][0] >= run.motions[0].end_s - 1e-9


MISMATCHES = [
    ('$n = "p"\nCALLS $n(1)', ".PROGRAM p(x)\nMOVE x\n.END\n"),
    ('$n = "p"\nCALLS $n(1)', ".PROGRAM p(x[])\nx[1] = 1\n.END\n"),
    ('$n = "p"\nCALLS $n(m[])', ".PROGRAM p(x)\nx = 1\n.END\n"),
    ('$n = "p"\nCALLS $n("text")', ".PROGRAM p(x)\nTYPE x+1\n.END\n"),
]


@pytest.mark.parametrize(("body", "more"), MISMATCHES)
def test_arguments_that_do_not_fit_are_found_at_run_time(body: str, more: str) -> None:
    assert words(runs("m[1] = 1\n" + body, more, dialect="vplus")) == ["Program argument mismatch"]
