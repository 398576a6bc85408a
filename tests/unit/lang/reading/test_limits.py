"""Limits: at each all is well, just beyond it there is one diagnostic and no more."""

import time
from collections.abc import Callable

import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.ir.dump import dump
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import AS, VAL2, VAL2_PLUS, Dialect
from vrts.lang.problems import LIMIT, MOST_KEPT, Problems
from vrts.lang.reading.decoding import MAX_BYTES, decode
from vrts.lang.reading.splitter import MAX_STEPS
from vrts.lang.reading.tokeniser import MOST_BAD, tokenise
from vrts.lang.steps import step_parser
from vrts.lang.steps.trials import MOST_OF_LINE
from vrts.lang.syntax.token import Token
from vrts.lang.writing.layout import layout
from vrts.scene.default import robot_alone

LONG = "V106"  # lines beyond 132 characters, which come along


def codes(body: str, dialect: Dialect = VAL2) -> list[str]:
    text = f".PROGRAM main(x)\n{body}\n.END\n"
    found = compile_source(SourceFile("a.v2", text), Options(dialect)).diagnostics
    return [d.rule.code for d in found if d.rule.code != LONG]


def test_size_of_a_file() -> None:
    step = b"        READY\n"
    data = b".PROGRAM main\n" + step * 10
    filled = data + b";" * 9_000
    assert not isinstance(decode(filled, "a.v2"), Diagnostic)
    padding = b"\n" * (MAX_BYTES - len(data))
    assert not isinstance(decode(data + padding, "a.v2"), Diagnostic)
    beyond = decode(data + padding + b"\n", "a.v2")
    assert isinstance(beyond, Diagnostic)
    assert beyond.rule.code == "V103"


@pytest.mark.parametrize(("dialect", "most"), [(VAL2, 255), (VAL2_PLUS, 4096)])
def test_length_of_a_line(dialect: Dialect, most: int) -> None:
    step = "TYPE 1" + ",1" * ((most - 6) // 2)
    fitting = step + " " * 40 + "; a comment does not count"
    assert codes(fitting, dialect) == []
    assert codes(step + ",1", dialect) == ["V105"]


def test_nesting() -> None:
    for brackets in ("()", "[]"):
        name = "y" if brackets == "[]" else ""
        step = "TYPE " + f"{name}{brackets[0]}" * 120 + "1" + brackets[1] * 120
        assert "V113" not in codes(step, VAL2_PLUS)
    deep = "TYPE " + "(" * 201 + "1" + ")" * 201
    assert codes("TYPE " + "(" * 200 + "1" + ")" * 200, VAL2_PLUS) == []
    assert codes(deep, VAL2_PLUS) == ["V113"]


def test_operators_in_a_row() -> None:
    for sign in ("+", "*", " AND ", ":"):
        start = "SET x = a" if sign == ":" else "x = a"
        assert set(codes(start + f"{sign}a" * 390, VAL2_PLUS)) <= {"V204", "V205"}
        assert codes(start + f"{sign}a" * 410, VAL2_PLUS) == ["V113"]


def test_deep_expressions_are_laid_out_dumped_and_run() -> None:
    deep = "(" * 190 + "1" + ")" * 190 + "*1" * 150
    text = f".PROGRAM main\nTYPE {deep}\nTYPE SIN({deep}+0)\n.END\n"
    source = SourceFile("a.v2", text)
    module = compile_source(source, Options(VAL2_PLUS)).module
    assert module is not None
    assert dump(module)
    assert layout(source, VAL2_PLUS).count("\n") == text.count("\n")
    assert execute(module, robot_alone()).output.startswith(" 1")


@pytest.mark.thorough
def test_steps_of_a_program() -> None:
    assert codes("READY\n" * (MAX_STEPS - 1)) == []
    assert codes("READY\n" * (MAX_STEPS + 1)) == ["V115"]


def test_number_of_diagnostics() -> None:
    found = codes("MOVEE x\n" * (LIMIT - 1))
    assert found == ["V120"] * (LIMIT - 1)
    found = codes("MOVEE x\n" * (LIMIT + 7))
    assert found == ["V120"] * LIMIT + ["V151"]


@pytest.mark.thorough
@pytest.mark.parametrize(
    "body",
    [
        "IF x THEN\n" * 30_000,
        "DO\n" * 10_000 + "EXIT\n" * 10_000 + "UNTIL x\n" * 10_000,
        "GOTO 60000\n" * 30_000 + "60000 READY",
        "".join(f"name{k:05d} = nama{k:05d}\n" for k in range(20_000)),
        "".join(f".END\n.PROGRAM p{k}\nCALL p{k + 1}\nWHILE x DO\nEND\n" for k in range(5_000)),
    ],
    ids=["open", "exits", "jumps", "names", "calls"],
)
def test_what_was_quadratic_once_is_answered(body: str) -> None:
    assert codes(body)  # would take minutes


def test_long_lists_are_no_riddle() -> None:
    for body in ("q = [" + "1," * 120, "for (" + "; " * 120, "MOVE (" + "1," * 120):
        assert codes(body)  # would take minutes


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("more", "expected"),
    [
        (".REALS\n.END\n", {"V115"}),
        pytest.param("", set[str](), marks=pytest.mark.thorough),  # all of them are looked at
    ],
)
def test_lines_of_a_file(more: str, expected: set[str]) -> None:
    section = ".REALS\n" + "a 1\n" * 49_999 + ".END\n"
    text = section * 2 + ".PROGRAM main\n" + "READY\n" * 49_999 + ".END\n" + more
    found = compile_source(SourceFile("a.v2", text), Options(VAL2)).diagnostics
    assert {d.rule.code for d in found if d.is_error} - {"V151"} == expected


def test_of_what_is_found_beyond_only_the_number_is_kept() -> None:
    signs = 30
    source = SourceFile("a.v2", f".PROGRAM main\n{('?' * signs + chr(10)) * 10_000}.END\n")
    problems = compile_source(source, Options(VAL2)).diagnostics
    assert [d.rule.code for d in problems] == ["V107"] * LIMIT + ["V151"]
    more = problems[-1].data["more"]
    assert isinstance(more, int)
    assert signs > MOST_BAD  # a line is left after so many
    assert MOST_KEPT <= more + LIMIT <= MOST_KEPT + MOST_BAD


def test_errors_are_shown_before_warnings_that_fill_the_memory() -> None:
    text = ".END\n" * (MOST_KEPT + 10) + ".PROGRAM main\nMOVEE x\n.END\n"
    found = compile_source(SourceFile("a.v2", text), Options(VAL2)).diagnostics
    assert [d.rule.code for d in found if d.is_error] == ["V120", "V151"]


def chain(count: int, call: str) -> str:
    return "".join(f".PROGRAM p{k}(a)\n" + call.format(k + 1) + ".END\n" for k in range(count))


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("dialect", "text"),
    [
        (VAL2, chain(9000, "CALL p{}(a)\n") + ".PROGRAM q\nCALL p0(x)\ny = x\n.END\n"),
        (VAL2, chain(60, "CALL p{0}(a)\nCALL p{0}(a)\n") + ".PROGRAM p60(a)\ny = a+1\n.END\n"),
        (VAL2, chain(49, "CALL p{0}\nCALL p{0}\nWHILE x DO\nCALL p{0}\nEND\n")),
        (VAL2, chain(400, "{0} READY\n" * 70 + "GOTO 9\n" * 70)),
        (AS, ".PROGRAM q\n" + "".join(f".v{k} = 1\n" for k in range(20_000)) + ".END\n"),
        (VAL2, ".PROGRAM q(" + "," * 9_900 + ")\n.END\n"),
        (VAL2, ".PROGRAM q(" + ",".join(f"a{k:04}" for k in range(1_600)) + ")\n.END\n"),
        (VAL2, ("PROGRAM a" + " " * 9_900 + "x\n") * 40),
    ],
    ids=["deep", "twice", "loops", "labels", "locals", "commas", "formals", "blanks"],
)
def test_nothing_is_looked_at_again_and_again(dialect: Dialect, text: str) -> None:
    found = compile_source(SourceFile("a.v2", text), Options(dialect))
    assert found.module is not None or found.diagnostics


@pytest.mark.parametrize("word", ["a ", "1 ", "+ ", '"a" ', "\u02c6"])
def test_trials_of_one_line(word: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Words alike in a row were each left out in turn, and within that the next, and the next."""
    read: list[str] = []

    def counted(text: str, at: int, problems: Problems) -> list[Token] | None:
        read.append(text)
        return tokenise(text, at, problems)

    monkeypatch.setattr(step_parser, "tokenise", counted)
    assert len(codes(f"WAIT SIG(1001) OR (TIMER(1){word * 20} > 5)", VAL2_PLUS)) == 1
    assert 1 < len(read) <= MOST_OF_LINE + 1


def loops_that_do_nothing(count: int) -> str:
    return ".PROGRAM main()\n" + "FOR i = 1 TO 2\nEND\n" * count + ".END\n"


def nested_loops_with_calls(count: int) -> str:
    opened = "".join(f"FOR i{k} = 1 TO 2\n" for k in range(count))
    inside = "CALL other(i1)\n" * count
    other = ".PROGRAM other(a)\nb = a\n.END\n"
    return ".PROGRAM main()\n" + opened + inside + "END\n" * count + ".END\n" + other


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (nested_loops_with_calls, 400),
        pytest.param(loops_that_do_nothing, 5000, marks=pytest.mark.thorough),
    ],
)
def test_twice_as_many_loops_take_twice_as_long(text: Callable[[int], str], count: int) -> None:
    def seconds(size: int) -> float:
        source = SourceFile("a.v2", text(size))
        begin = time.process_time()
        assert compile_source(source, Options(VAL2_PLUS)).diagnostics
        return time.process_time() - begin

    # the quickest of some tries: whatever else the machine does only makes it slower
    once, twice = (min(seconds(size) for _ in range(3)) for size in (count, 2 * count))
    assert twice < 2.9 * once
