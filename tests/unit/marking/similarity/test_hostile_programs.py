"""No program of one student makes the comparison of a class slow."""

import sys
import time
from collections.abc import Generator
from contextlib import contextmanager
from types import FrameType, SimpleNamespace
from typing import Any, cast

import pytest

from vrts.ir.module import Module
from vrts.marking.marking import Done
from vrts.marking.result import Kind
from vrts.marking.similarity.features.code import code_features
from vrts.marking.similarity.features.extract import Program, features_of
from vrts.marking.similarity.features.steps import LONGEST, MOST_NUMBERS, MOST_STEPS, steps_of
from vrts.marking.similarity.features.taught import taught
from vrts.marking.similarity.files import programs_of
from vrts.marking.similarity.symbols import Reader, readable
from vrts.pipeline.compiling.programs import Compiled, compile_bytes


@contextmanager
def at_most(lines: int) -> Generator[None]:
    """Fail once more lines of the features have been executed."""
    left = lines

    def trace(frame: FrameType, event: str, _: object) -> Any:
        nonlocal left
        if "similarity" not in frame.f_code.co_filename:
            return None
        left -= event == "line"
        if left < 0:
            pytest.fail(f"more than {lines} lines")
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        yield
    finally:
        sys.settrace(before)


def module(text: str) -> Module:
    """Return what a text compiles to."""
    found = compile_bytes(text.encode(), "a").compilation
    assert found is not None
    assert found.module is not None
    return found.module


def test_calls_of_calls_are_visited_so_often_and_no_more() -> None:
    programs = [".PROGRAM main()\n  IF 0 THEN\n    CALL p0\n  END\n.END\n"]
    for k in range(7):
        programs.append(f".PROGRAM p{k}()\n" + f"  CALL p{k + 1}\n" * 50 + ".END\n")
    whole = module("".join([*programs, '.PROGRAM p7()\n  TYPE "x"\n.END\n']))
    with at_most(3_000_000):
        assert len(steps_of(whole)) <= MOST_STEPS


def test_a_long_chain_of_variables_is_followed_once() -> None:
    steps = [f"  v{k} = v{k + 1}" for k in range(1500)]
    for lines in (steps, steps[::-1]):
        whole = module(
            "\n".join([".PROGRAM main()", "  v1500 = x", *lines, "  DELAY v0", ".END\n"])
        )
        with at_most(600_000):
            assert len(steps_of(whole)) == 1502


def test_what_repeats_a_long_step_is_short() -> None:
    step = "  SIGNAL " + ",".join(["1"] * 100)
    many = module(".PROGRAM main()\n" + f"{step}\n" * 400 + ".END\n")
    found = steps_of(many)
    assert found
    assert all(len(one.exact) <= LONGEST and len(one.numbers) <= MOST_NUMBERS for one in found)
    assert sum(1 for _ in code_features(many)) <= 100_000


def test_a_line_that_nearly_is_a_value_takes_time_by_its_length() -> None:
    lines = f"a{'1' * 1500}{' 1' * 700}!\n" * 300
    text = f".PROGRAM main()\n.END\n.LOCATIONS\n{lines}b[2] 1 2 3.50\n.END\n"
    file = readable(text.encode(), "a")
    assert file is not None
    begun = time.process_time()
    assert [one.numbers for one in taught(file)] == [(1.0, 2.0, 3.5)]
    assert time.process_time() - begun < 5.0  # [s]: a thousand times what it takes


def test_a_program_of_very_many_lines_is_compared_without_being_compiled(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    compiled: list[bytes] = []

    def counted(data: bytes, name: str) -> Compiled:
        compiled.append(data)
        return compile_bytes(data, name)

    monkeypatch.setattr("vrts.marking.similarity.features.extract.compile_bytes", counted)
    short, long = (
        (".PROGRAM main()\n" + "READY\n" * count + ".END\n").encode() for count in (20, 20_000)
    )
    for data in (short, long):
        assert list(features_of(Program(data), "a", Reader()))
    assert compiled == [short]


def test_a_submission_whose_process_was_ended_is_not_compared() -> None:
    def done(name: str, kind: Kind, data: bytes | None = b"x") -> Done:
        entry = SimpleNamespace(identifier=name, data=data)
        return cast("Done", SimpleNamespace(entry=entry, result=SimpleNamespace(kind=kind)))

    some = [done("a", Kind.GRADED), done("b", Kind.RESOURCE), done("c", Kind.FAULT)]
    none = done("d", Kind.MISSING, None)
    assert programs_of([*some, none]) == {"a": b"x"}
