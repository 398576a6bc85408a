"""Work grows with the size of a program as the program does: twice as long, twice the work."""

from collections.abc import Callable

import pytest

from tests.laws import first
from tests.support_programs import ALONE, compiled
from tests.work import growth
from vrts.base.source import SourceFile
from vrts.check.verdicts.limits import check_limits
from vrts.engine.controller import execute
from vrts.lang.compiler import compile_source
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.run_files.loading import load_run
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import Simulated, simulate

MOST = 2.25  # times the work, for twice the size


def with_locations(count: int) -> str:
    places = "\n".join(f"p{k} 900 {200 - k % 90} 100 90 90 0" for k in range(count + 1))
    return f".PROGRAM main\nMOVE p0\n.END\n.LOCATIONS\n{places}\n.END\n"


def with_elements(count: int) -> str:
    places = "\n".join(f"p[{k}] 900 {200 - k % 90} 100 90 90 0" for k in range(count + 1))
    return f".PROGRAM main\nMOVE p[0]\n.END\n.LOCATIONS\n{places}\n.END\n"


def with_variables(count: int) -> str:
    lines = "\n".join(f"v{k} = {k}" for k in range(count + 1))
    return f".PROGRAM main\n{lines}\n.END\n"


def with_steps(count: int) -> str:
    lines = "\n".join(f"IF x > {k} THEN\ny = x+{k}\nEND" for k in range(count))
    return f".PROGRAM main\nx = 1\n{lines}\n.END\n"


def with_programs(count: int) -> str:
    calls = "\n".join(f"CALL q{k}" for k in range(count))
    others = "".join(f".PROGRAM q{k}\ny = {k}\n.END\n" for k in range(count))
    return f".PROGRAM main\ny = 0\n{calls}\n.END\n{others}"


def with_motions(count: int) -> str:
    lines = "\n".join(f"MOVE p{k % 2}" for k in range(count))
    return (
        f".PROGRAM main\n{lines}\n.END\n.LOCATIONS\n"
        "p0 900 200 100 90 90 0\np1 900 190 100 90 90 0\n.END\n"
    )


def with_events(count: int) -> str:
    return f".PROGRAM main\nFOR i = 1 TO {count}\nSIGNAL 1, -1\nTYPE i\nEND\n.END\n"


KINDS: dict[str, tuple[Callable[[int], str], int]] = {
    "locations": (with_locations, 120),
    "elements": (with_elements, 120),
    "variables": (with_variables, 240),
    "steps": (with_steps, 160),
    "programs": (with_programs, 60),
    "motions": (with_motions, 20),
    "events": (with_events, 80),
}


WRONG: dict[str, Callable[[int], str]] = {
    "structures without an end": "IF x THEN\n".__mul__,
    "structures that an UNTIL leaves open": lambda count: (
        "DO\n" + "IF x THEN\n" * count + "UNTIL x\n"
    ),
    "an ELSE behind each IF with GOTO": "IF x GOTO 10\nELSE\n".__mul__,
    "an END that ends nothing": "END\n".__mul__,
}


@pytest.mark.parametrize("kind", WRONG)
def test_what_is_said_of_wrong_programs_grows_with_them(kind: str) -> None:
    def compiling(count: int) -> Callable[[], object]:
        source = SourceFile("main.v2", f".PROGRAM main\n{WRONG[kind](count)}.END\n")
        return lambda: compile_source(source)

    assert growth(compiling, 250) < MOST


def simulated(text: str) -> Simulated:
    return simulate(Request(ProgramFile(text.encode(), "main.v2"), robot_alone()))


@pytest.mark.parametrize("kind", KINDS)
def test_compiling_and_executing_grow_with_the_program(kind: str) -> None:
    text, size = KINDS[kind]

    def compiling(count: int) -> Callable[[], object]:
        source = SourceFile("main.v2", text(count))
        return lambda: compile_source(source)

    def executing(count: int) -> Callable[[], object]:
        module = compiled(text(count))
        return lambda: execute(module, ALONE)

    if text(size) != text(2 * size).replace(str(2 * size), str(size)):  # else a loop is longer
        assert growth(compiling, size) < MOST
    assert growth(executing, size) < MOST


@pytest.mark.parametrize("kind", first(2, KINDS))
def test_checking_saving_and_loading_grow_with_the_program(kind: str) -> None:
    text, size = KINDS[kind]

    def checking(count: int) -> Callable[[], object]:
        run = execute(compiled(text(count)), ALONE)
        return lambda: check_limits(run)

    def saving(count: int) -> Callable[[], object]:
        found = simulated(text(count))
        return lambda: saved_bytes(found)

    def loading(count: int) -> Callable[[], object]:
        data = saved_bytes(simulated(text(count)))
        return lambda: load_run(data, "main.vrun").run

    if kind == "motions":
        assert growth(checking, size) < MOST
    assert growth(saving, size) < MOST
    assert growth(loading, size) < MOST
