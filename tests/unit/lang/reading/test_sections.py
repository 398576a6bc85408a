"""Headers, ends and lines that stand where they mean nothing: told once, where they are, mended."""

import pytest

from tests.mistakes import compiled, said
from vrts.ir.dump import dump


def told(text: str) -> list[tuple[int, str]]:
    """Return line and code of what is said of a program."""
    return [(d.primary.span.line if d.primary else 0, d.rule.code) for d in said(compiled(text))]


def mended(text: str) -> str:
    """Return a program after the edit of its one diagnostic."""
    (found,) = said(compiled(text))
    assert found.fix is not None
    start, end = found.fix.span.start, found.fix.span.end
    return text[:start] + found.fix.replacement + text[end:]


CALLED = ".PROGRAM main\n        CALL grip(40)\n.END\n"
GRIP = CALLED + ".PROGRAM grip(s)\n        SPEED s\n.END\n"


@pytest.mark.parametrize(
    "header",
    [
        ".PROGRAM grip[s]",
        ".PROGRAM grip{s}",
        ".PROGRAM grip(s",
        ".PROGRAM grip, s",
        ".PROGRAM grip(REAL s)",
        ".PROGRAM grip(s: real)",
        ".PROGRAM grip(s = 5)",
        '.PROGRAM "grip"(s)',
        ".PROGRAM: grip(s)",
        ".PROGRAM grip(s):",
        ".PROGRAM grip(s) as real",
        ".PROGAM grip(s)",
        ".PROCEDURE grip(s)",
        ". PROGRAM grip(s)",
        ",PROGRAM grip(s)",
    ],
)
def test_a_header_written_otherwise_is_read_as_meant(header: str) -> None:
    """One message at the header, none at calls and steps, and its edit makes what was meant."""
    text = GRIP.replace(".PROGRAM grip(s)", header)
    assert [line for line, _ in told(text)] == [4]
    right, wrong = compiled(GRIP).module, compiled(mended(text)).module
    assert right is not None
    assert wrong is not None
    assert dump(wrong) == dump(right)


@pytest.mark.parametrize(
    "header",
    [".PROGRAM grip(40)", '.PROGRAM grip("s")', ".PROGRAM grip s", ".PROGRAM 1(s)", ".PROGRAM"],
)
def test_a_header_that_could_mean_several_is_told_once(header: str) -> None:
    """What follows from a broken header is not told."""
    assert told(GRIP.replace(".PROGRAM grip(s)", header)) == [(4, "V142")]


def test_a_formal_that_stands_twice_still_counts() -> None:
    """CALL with as many arguments is not blamed."""
    text = GRIP.replace("grip(s)", "grip(s, s)").replace("(40)", "(40, 5)")
    assert told(text) == [(4, "V217")]


@pytest.mark.parametrize(
    ("wrong", "line", "code"),
    [
        (".PROGRAM a\n READY\nEND\n", 3, "V141"),
        (".PROGRAM a\n READY\nEND PROGRAM\n", 3, "V141"),
        (".PROGRAM a\n IF SIG(1) THEN\n  READY\n END\nEND\n", 5, "V141"),
        (".PROGRAM a\n IF SIG(1) THEN\n  READY\n .END\n READY\n.END\n", 4, "V166"),
        (".PROGRAM a\n IF SIG(1) THEN\n  READY\n .END\n.END\n", 4, "V166"),
        (".PROGRAM a\n MOVE p\n.END\n.LOCATION\np 500 0 -100 90 90 0\n.END\n", 4, "V144"),
        (".PROGRAM a\n MOVE p\n.END\nLOCATIONS:\np 500 0 -100 90 90 0\n.END\n", 4, "V144"),
        (".PROGRAM a\n MOVE p\n.END\n.LOCATIONS\np 500 0 -100 90 90 0\nEND\n", 6, "V141"),
        (".PROGRAM a\n MOVE p\n.END\np 500 0 -100 90 90 0\n", 4, "V165"),
        (".PROGRAM a\n MOVE p\n.END\np 500 0 -100 90 90 0\n.END\n", 4, "V165"),
        (".PROGRAM a\n MOVE p\np 500 0 -100 90 90 0\n.END\n", 3, "V165"),
        (".PROGRAM a\n SPEED v\n.END\nv 50\n", 4, "V165"),
        (".PROGRAM a\n READY\n.END\n.END\n", 4, "V140"),
        (".PROGRAM a\n READY\n.PROGRAM b\n READY\n.END\n", 3, "V141"),
        (".PROGRAM a\n READY\n.END.\n", 3, "V144"),
    ],
)
def test_odd_ends_and_places_are_told_once_and_mended(wrong: str, line: int, code: str) -> None:
    """One cause, one diagnostic, and the edit leaves nothing to say."""
    assert told(wrong) == [(line, code)]
    assert told(mended(wrong)) == []


def test_a_program_without_its_end_takes_a_later_one() -> None:
    """`.END` twice at the end closes two programs: nothing is told of the second."""
    text = ".PROGRAM a\n READY\n.PROGRAM b\n READY\n.END\n.END\n"
    assert told(text) == [(3, "V141")]


def test_steps_outside_of_programs_are_not_a_second_main() -> None:
    """A program `main` of its own is not told to stand twice."""
    main = ".PROGRAM main\n READY\n.END\n"
    assert told(f"SPEED 50 ALWAYS\n{main}") == [(1, "V140")]
    assert told(f"{main}TYPE 1\n") == [(4, "V140")]


@pytest.mark.parametrize(
    "step",
    ["n = 1", "x = -1 -2 -3", "SPEED 20", "DRIVE 1, -20", "10 TYPE 1, 2, 3", "DRAW 1, 2 , 3"],
)
def test_steps_with_numbers_are_no_values(step: str) -> None:
    """Only a name with several numbers between blanks is a line of data."""
    assert [code for _, code in told(f".PROGRAM a\n {step}\n.END\n")] == []


def test_sections_of_as_are_not_corrected() -> None:
    """AS has many sections: a word like another is one of them."""
    text = ".PROGRAM a()\n TYPE 1\n.END\n.REAL\nx 1\n.END\n"
    assert (4, "V144") in told(text)
