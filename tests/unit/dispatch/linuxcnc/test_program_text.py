"""What programs become in G-code, and what is refused with its line."""

import pytest

from vrts.base.source import SourceFile
from vrts.dispatch.linuxcnc.names import LONGEST, number
from vrts.dispatch.linuxcnc.program_text import Said, said
from vrts.dispatch.saying.table import Table
from vrts.lang.compiler import Options, compile_source, resolve_source
from vrts.lang.dialect import VAL2

TABLE = Table({1001: 0, 1002: 5}, {1: 2, 2: 3}, 0, 1)
PLACES = "a 900 200 -100 90 90 0\nb 0 0 20 90 -90 0\n#p 0 -90 90 0 0 0\n"


def gcode(steps: str, more: str = "") -> Said:
    """Return a program with these steps in G-code."""
    text = f".PROGRAM main\n{steps}\n.END\n{more}.LOCATIONS\n{PLACES}.END\n"
    source = SourceFile("main.v2", text)
    compilation = compile_source(source, Options(VAL2))
    assert compilation.module is not None, compilation.diagnostics
    found = resolve_source(source, VAL2)
    assert found is not None
    return said(found, compilation.module, "main", TABLE)


def steps_of(steps: str, more: str = "") -> list[str]:
    """Return what steps become, without comments and the last stop."""
    found = gcode(steps, more)
    assert not found.diagnostics, found.diagnostics
    body = found.text[found.text.rindex("\n\n") :].strip().split("\n")
    assert body[-3:] == ["o<v_stop> call", "G94", "M2"]
    return [row.strip() for row in body[:-3] if not row.lstrip().startswith(";")]


@pytest.mark.parametrize(
    ("step", "written"),
    [
        ("MOVE a", ["o<v_move> call [#<_at_a>]"]),
        ("MOVES a", ["o<v_moves> call [#<_at_a>]"]),
        ("MOVE #p", ["o<v_joints> call [#<_at_j_p>]"]),
        ("APPRO a, 50", ["o<v_appro> call [#<_at_a>] [50]"]),
        ("APPROS a, n", ["o<v_appros> call [#<_at_a>] [#<_val_n>]"]),
        ("DEPARTS 2*30", ["o<v_departs> call [[2 * 30]]"]),
        ("DRAW 10,,-20", ["o<v_draw> call [10] [0] [[0 - 20]]"]),
        ("READY", ["o<v_joints> call [154]"]),
        ("BREAK", ["o<v_stop> call"]),
        ("DELAY 0.5", ["o<v_delay> call [0.5]"]),
        ("OPENI", ["o<v_hand> call [1]"]),
        ("CLOSE", ["#<_v_hand> = 2"]),
        (
            "TOOL NULL",
            ["o<v_trans> call [1000] [0] [0] [0] [90] [-90] [0]", "o<v_tool> call [1000]"],
        ),
        ("SPEED 30", ["#<_v_speed_next> = [30/100]"]),
        ("SPEED 150 MMPS ALWAYS", ["#<_v_speed_always> = [150/#<_v_linear>]"]),
        ("FLIP", ["o<v_stop> call", "#<_v_ask_wrist> = [-1]"]),
        ("SIGNAL 1, -2", ["o<v_output> call [2] [1]", "o<v_output> call [3] [0]"]),
        ("SIGNAL 2001", ["#<_signal_2001> = 1"]),
        ("x = -n+2", ["#<_val_x> = [[0 - #<_val_n>] + 2]"]),
        ("x = n > 2", ["#<_val_x> = [0 - [#<_val_n> GT 2]]"]),
        ("SET c = a", ["o<v_copy> call [#<_at_c>] [#<_at_a>] [12]"]),
        ('TYPE "it is (1)", n', ["#<k1> = [#<_val_n>]", "(PRINT, it is [1] #<k1>)"]),
        ("HALT", ["o<v_stop> call", "G94", "M2"]),
    ],
)
def test_a_step(step: str, written: list[str]) -> None:
    assert steps_of(step) == written


def test_each_step_stands_before_what_became_of_it() -> None:
    text = gcode("MOVE a\nBREAK").text
    assert ";   1  MOVE a\no<v_move> call [#<_at_a>]\n;   2  BREAK\no<v_stop> call\n" in text


def test_structures_stay_structures() -> None:
    steps = "FOR i = 1 TO n STEP 2\nIF i == 3 THEN\nMOVE a\nELSE\nMOVES a\nEND\nEND"
    assert steps_of(steps) == [
        "#<_val_i> = 1",
        "#<last101> = #<_val_n>",
        "o101 while [#<_val_i> LE #<last101>]",
        "o102 if [#<_val_i> EQ 3]",
        "o<v_move> call [#<_at_a>]",
        "o102 else",
        "o<v_moves> call [#<_at_a>]",
        "o102 endif",
        "#<_val_i> = [#<_val_i> + 2]",
        "o101 endwhile",
    ]
    assert steps_of("CASE n OF\nVALUE 1, 2:\nMOVE a\nANY\nREADY\nEND") == [
        "#<case101> = #<_val_n>",
        "o101 if [[#<case101> EQ 1] OR [#<case101> EQ 2]]",
        "o<v_move> call [#<_at_a>]",
        "o101 else",
        "o<v_joints> call [154]",
        "o101 endif",
    ]
    assert steps_of("DO\nn = n+1\nUNTIL n > 3") == [
        "o101 do",
        "#<_val_n> = [#<_val_n> + 1]",
        "o101 while [[#<_val_n> GT 3] EQ 0]",
    ]


def test_a_loop_looks_at_its_inputs_each_time() -> None:
    assert steps_of("WHILE SIG(1001, -1002) DO\nn = 1\nEND") == [
        "o<v_stop> call",
        "o101 while [1]",
        "o<v_input> call [0]",
        "#<k1> = #<_v_read>",
        "o<v_input> call [5]",
        "#<k2> = #<_v_read>",
        "o102 if [[[#<k1> NE 0] AND [#<k2> EQ 0]] EQ 0]",
        "o101 break",
        "o102 endif",
        "#<_val_n> = 1",
        "o101 endwhile",
    ]


def test_a_wait_is_repeated_until_it_is_true() -> None:
    assert steps_of("WAIT SIG(1001)") == [
        "o<v_stop> call",
        "o<v_stop> call",
        "o101 do",
        "o<v_input> call [0]",
        "#<k1> = #<_v_read>",
        "o101 while [[#<k1> NE 0] EQ 0]",
    ]


def test_remainders_and_signs_are_those_of_val() -> None:
    assert steps_of("x = n MOD 3")[-1] == (
        "#<_val_x> = [#<k1> - #<k2>*[FIX[#<k3>] + [[#<k3> LT 0] AND [FIX[#<k3>] NE #<k3>]]]]"
    )
    assert steps_of("x = SIGN(n)") == ["#<_val_x> = [2*[#<_val_n> GE 0] - 1]"]


def test_a_number_given_to_an_argument_comes_back() -> None:
    more = ".PROGRAM add(x, by)\nIF by == 0 THEN\nRETURN\nEND\nx = x + by\n.END\n"
    text = gcode("n = 1\nCALL add(n, 2)\nCALL add(n*2, 2)", more).text
    assert text.count("#<_back_add_0> = #<x>") == 2  # at RETURN and at the end
    assert "o<add> call [#<_val_n>] [2]\n#<_val_n> = #<_back_add_0>\n" in text
    assert text.count("#<_val_n> = #<_back_add_0>") == 1


def test_calls_that_are_too_deep_for_linuxcnc_are_refused_with_their_line() -> None:
    more = "".join(f".PROGRAM p{k}\nCALL p{k + 1}\n.END\n" for k in range(1, 3))
    deepest = ".PROGRAM p3\nMOVES a\n{}.END\n"
    assert not gcode("CALL p1", more + deepest.format("")).diagnostics
    (found,) = gcode("CALL p1", more + deepest.format("APPROS a, 20\n")).diagnostics
    assert found.headline.startswith("calls are 3 deep here, this takes 7 more")
    assert found.primary is not None
    assert found.primary.span.text == "APPROS a, 20"


def test_programs_are_subroutines_and_take_numbers_and_places() -> None:
    more = ".PROGRAM dip(place, by.mm)\nAPPROS place, by.mm\nRETURN\n.END\n"
    text = gcode("CALL dip(a, 40)\nCALL dip(a:b, n)", more).text
    assert "o<dip> call [#<_at_a>] [40]" in text
    assert "o<v_compose> call [1049] [#<_at_a>] [#<_at_b>]" in text or "o<v_compose>" in text
    assert (
        "o<dip> sub\n  #<place> = #1\n  #<by_mm> = #2\n"
        "  ;   1  APPROS place, by.mm\n  o<v_appros> call [#<place>] [#<by_mm>]\n"
        "  ;   2  RETURN\n  o<dip> return\no<dip> endsub\n"
    ) in text
    assert text.index("o<dip> sub") < text.index("o<dip> call")


def test_elements_of_arrays_are_looked_up_within_their_bounds() -> None:
    assert steps_of("SET g[3] = a\ni = 2\nMOVE g[i+1]") == [
        "o<v_copy> call [#<_at_g> + 36] [#<_at_a>] [12]",
        "#<_val_i> = 2",
        "o<v_element> call [#<_at_g>] [[#<_val_i> + 1]] [25] [12]",
        "#<k1> = #<_v_at>",
        "o<v_move> call [#<k1>]",
    ]


@pytest.mark.parametrize(
    ("steps", "line", "says"),
    [
        ("MOVE a\nIF SIG(1001) THEN\nEND", 3, "the arm may still move"),
        ("DELAY 1\nWAIT SIG(1001)", 3, "the arm may still move"),
        ("MOVE a\nHERE c", 3, "the arm may still move"),
        ("IF SIG(1003) THEN\nEND", 2, "signal 1003 is not in io.toml"),
        ("SIGNAL 7", 2, "signal 7 is not in io.toml"),
        ("SIGNAL n", 2, "worked out in the run"),
        ("IF n GOTO 10\nGRASP 5, 10\n10 MOVE a", 3, "GRASP"),
        ("REACT 1001, other", 2, "REACT: G-code is not interrupted"),
        ("REACTI 1001, other", 2, "REACT: G-code is not interrupted"),
        ("PCEXECUTE other", 2, "PCEXECUTE"),
        ('PROMPT "n: ", n', 2, "PROMPT"),
        ("BASE 10", 2, "BASE"),
        ('$m = "a"', 2, "no strings"),
        ("SINGLE ALWAYS", 2, "SINGLE"),
        ("x = TIMER(n)", 2, "the number of a timer"),
        ("MOVE a\nTIMER 1 = 0", 3, "the arm may still move"),
        ("FOR i = 1 TO 3 STEP n\nEND", 2, "the step of a FOR"),
        ("CALL other2(n)", 2, "which changes it too"),
        ("x[1,2] = 3", 1, "two subscripts"),
        ("CALL again", 1, "comes to call itself"),
    ],
)
def test_what_cannot_be_said_is_refused_with_its_line(steps: str, line: int, says: str) -> None:
    more = ".PROGRAM other\nREADY\n.END\n.PROGRAM other2(v)\nv = 1\nn = 2\n.END\n"
    more += ".PROGRAM again\nCALL again\n.END\n"
    (found, *_) = gcode(steps, more).diagnostics
    assert found.rule.code == "V870"
    assert says in found.headline
    assert found.primary is not None
    assert found.primary.span.line == line
    assert found.help


def test_jumps_go_from_one_numbered_stretch_to_another() -> None:
    text = gcode("10 n = n + 1\nIF n < 3 GOTO 10\nREADY").text
    rows = [row.strip() for row in text.split("\n") if not row.strip().startswith(";")]
    assert rows[rows.index("#<v_goto> = 0") :] == [
        "#<v_goto> = 0",
        "o101 while [#<v_goto> GE 0]",
        "o102 if [#<v_goto> EQ 0]",
        "#<_val_n> = [#<_val_n> + 1]",
        "o103 if [#<_val_n> LT 3]",
        "#<v_goto> = 0",
        "o103 else",
        "#<v_goto> = 1",
        "o103 endif",
        "o102 elseif [#<v_goto> EQ 1]",
        "o<v_joints> call [154]",
        "o<v_stop> call",
        "G94",
        "M2",
        "o102 endif",
        "o101 endwhile",
        "G94",
        "M2",
        "",
    ]


def test_timers_are_read_from_a_clock_at_rest() -> None:
    found = gcode("TIMER 2 = -1\nWAIT TIMER(2) > 0").text
    assert "o<v_clock> call\n#<_timer_2> = #<_v_now>\n" in found
    assert "o<v_clock> call\n#<_timer_2> = [#<_v_now> - [0 - 1]]\n" in found
    assert steps_of("x = TIMER(3)")[-3:] == [
        "o<v_clock> call",
        "#<k1> = [#<_v_now> - #<_timer_3>]",
        "#<_val_x> = #<k1>",
    ]


def test_lines_fit_into_linuxcnc_and_hold_no_exponent() -> None:
    found = gcode(f"x = {'+'.join(['n*2'] * 60)}")
    assert [d.headline for d in found.diagnostics] == ["the step is too long for a line of G-code"]
    long = gcode(f"MOVE a ; {'x' * 400}").text
    assert max(map(len, long.split("\n"))) <= LONGEST
    assert (number(1e-5), number(-0.25), number(2e7)) == ("0.00001", "[-0.25]", "20000000")


def test_a_break_before_lets_an_input_be_read_whatever_the_way_there() -> None:
    reads = "IF SIG(1001) THEN\nMOVE a\nEND\nBREAK\nWAIT SIG(1001)"
    assert not gcode(reads).diagnostics
    loop = "FOR i = 1 TO 2\nWAIT SIG(1001)\nMOVE a\nEND"
    assert len(gcode(loop).diagnostics) == 1  # in the second round the arm moves
    through = "CALL go\nWAIT SIG(1001)"
    moving = ".PROGRAM go\nMOVE a\n.END\n"
    still = ".PROGRAM go\nMOVE a\nBREAK\n.END\n"
    assert len(gcode(through, moving).diagnostics) == 1
    assert not gcode(through, still).diagnostics
