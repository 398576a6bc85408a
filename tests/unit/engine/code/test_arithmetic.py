"""What expressions give, as `TYPE` shows it. The numbers are those of VAL-II's manual."""

import pytest

from tests.support_programs import codes, ran, run_body, typed

VALUES = [
    ("2 == 2", "-1"),
    ("2 > 3", "0"),
    ("(6 > 2) AND (10 <= 10)", "-1"),
    ("(6 < 2) OR (10 > 10)", "0"),
    ("NOT (6 == 6)", "0"),
    ("^B1001001 BAND ^B1110011", "65"),
    ("6 BOR 3", "7"),
    ("6 BXOR 3", "5"),
    ("COM 0", "-1"),
    ("COM 33", "-34"),
    ("17 MOD 5", "2"),
    ("5.5 MOD 2", "1.5"),
    ("-17 MOD 5", "-2"),
    ("2+3*4", "14"),
    ("(2+3)*4", "20"),
    ("10-4-3", "3"),
    ("2*-3", "-6"),
    ("5 AND 2", "-1"),
    ("NOT 5", "0"),
    ("NOT 0", "-1"),
    ('"abc" < "abd"', "-1"),
    ('"ab" < "abc"', "-1"),
    ('"a"+"b" == "ab"', "-1"),
    ("INT(10.8)", "10"),
    ("INT(-5.462)", "-5"),
    ("FRACT(-5.462)", "-0.462"),
    ("SIGN(0)", "1"),
    ("SIGN(-2)", "-1"),
    ("ABS(-3)", "3"),
    ("SQR(5)", "25"),
    ("SQRT(9)", "3"),
    ("ATAN2(1,-1)", "135"),
    ("ATAN2(0.123,0.251)", "26.10669"),
    ("ATAN2(131.25,-1.3)", "90.56748"),
    ("SIN(30)", "0.5"),
    ("COS(60)", "0.5"),
    ("OUTSIDE(0,10,10)", "0"),
    ("OUTSIDE(0,11,10)", "-1"),
    ("BCD(93)", "147"),
    ("DCB(147)", "93"),
    ("MAX(3,9,-2)", "9"),
    ("MIN(3,9,-2)", "-2"),
    ('LEN("hello")', "5"),
    ('ASC("sample",2)', "97"),
    ('VAL("123 Elm Street")', "123"),
    ('VAL("2.1E2")', "210"),
    ('VAL("abc")', "0"),
    ('POS("hello","l")', "3"),
    ('POS("hello","l",4)', "4"),
    ('POS("hello","z")', "0"),
]


@pytest.mark.parametrize(("expression", "expected"), VALUES)
def test_value(expression: str, expected: str) -> None:
    (line,) = typed(run_body(f"TYPE {expression}"))
    assert float(line) == pytest.approx(float(expected), abs=2e-5)


def test_equal_precedence_goes_from_left_to_right() -> None:
    assert typed(ran(".PROGRAM main\nx = 1 OR 0 == 1\nTYPE x\n.END\n")) == ["0"]


TEXTS = [
    ('TYPE "[", $MID("abcdefg",3,2), "]"', ["[cd]"]),
    ('TYPE "[", $MID("abc",5,2), "]"', ["[]"]),
    ('TYPE "[", /F8.2, 3.14159, "]"', ["[    3.14]"]),
    ('TYPE "[", /I4, 123456, "]"', ["[****]"]),
    ('TYPE "[", /I0, 5, "]"', ["[5]"]),
    ('TYPE "one", /C1, "two"', ["one", "two"]),
    ('$s = "ab"+"cd"\nTYPE $s', ["abcd"]),
]


@pytest.mark.parametrize(("body", "lines"), TEXTS)
def test_strings(body: str, lines: list[str]) -> None:
    assert typed(run_body(body)) == lines


def test_defined_tells_whether_there_is_a_value() -> None:
    text = ".PROGRAM main\nTYPE DEFINED(x)\nx = 1\nTYPE DEFINED(x)\n.END\n"
    assert typed(ran(text)) == ["0", "-1"]


FAULTS = [
    ("TYPE 1/0", "V251"),
    ("n = 0\nTYPE 5 MOD n", "V251"),
    ("x = 1E30\nTYPE x*x", "V252"),
    ("x = -1\nTYPE SQRT(x)", "V257"),
    ("IF SIG(1001) THEN\nx = 1\nEND\nTYPE x", "V250"),
    ("i = -1\nhole[i] = 1", "V254"),
    ('$s = "0123456789abcdef"\nFOR i = 1 TO 4\n$s = $s+$s\nEND', "V259"),
    ("i = 1\nGOTO 10\nFOR i = 1 TO 3\n10 READY\nEND", "V260"),
    ("n = 1001\nSIGNAL n", "V501"),
    ("s = 0\nSPEED s", "V253"),
    ("CALL main", "V258"),
]


@pytest.mark.parametrize(("body", "code"), FAULTS)
def test_fault_stops_the_program(body: str, code: str) -> None:
    run = run_body(body + '\nTYPE "after"')
    assert codes(run) == [code]
    assert run.ending.value == "error"
    assert "after" not in run.output
    assert all(found.primary is not None for found in run.findings)


def test_a_fault_says_vals_own_words() -> None:
    (found,) = run_body("TYPE 1/0").findings
    assert found.notes[-1] == "VAL-II says *Division by zero*"
