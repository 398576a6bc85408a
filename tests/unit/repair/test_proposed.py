"""What is proposed: a few steps whatever a text holds, and no slip that is none."""

from collections import Counter
from itertools import islice

import pytest

from tests.golden.examples import EXAMPLES
from tests.support_programs import ALONE
from vrts.base.source import SourceFile
from vrts.lang.dialect import DIALECTS
from vrts.pipeline.settings import load_task
from vrts.repair.blame.blame import Blame
from vrts.repair.surely import surely
from vrts.repair.table.asked import Asked
from vrts.repair.table.forgotten import ALL, FORMALS, MOST, WIDEST, forgotten
from vrts.repair.table.numbers import BACKWARD, other_numbers
from vrts.repair.written import read

TASK = load_task(EXAMPLES[0] / "task.toml").task
BEYOND_ALL = 10 * ALL  # steps looked at of those that may have no end


def asked(text: str, dialect: str = "val2") -> Asked:
    """Return what candidates are made from, of a text that was executed as a whole."""
    assert TASK is not None
    lines = frozenset(range(1, text.count("\n") + 2))
    blame = Blame({}, (), (), lines, None, frozenset(), (), slow=False)
    found = DIALECTS[dialect]
    return Asked(read(SourceFile("p.v2", text), found), ALONE, TASK, blame, found)


def steps(text: str) -> list[str]:
    """Return the steps that were surely meant, as far as anybody would look."""
    return [step[0] for step in islice(forgotten(asked(text)), BEYOND_ALL)]


def uncalled(formals: int, numbers: int, programs: int = 1) -> str:
    """Return programs that nobody calls, and numbers that they may be given."""
    given = "\n".join(f"n{k} = {k}" for k in range(numbers))
    names = ", ".join(f"f{k}" for k in range(formals))
    rest = [f".PROGRAM idle{k}({names})\nTYPE f0\n.END\n" for k in range(programs)]
    return f".PROGRAM main()\n{given}\n.END\n{''.join(rest)}"


def arguments(text: str) -> list[list[str]]:
    """Return the arguments of the calls proposed."""
    return [step[step.index("(") + 1 : -1].split(", ") for step in steps(text)]


def elements(*subscripts: int, idle: int = 1) -> list[str]:
    """Return the elements proposed of an array that has some."""
    body = "\n".join(f"SET w[{k}] = a" for k in subscripts)
    rows = "\n".join(f"idle{k} 900 0 0 90 90 0" for k in range(idle))
    return steps(
        f".PROGRAM main()\nMOVE a\n{body}\n.END\n.LOCATIONS\na 9 0 0 0 0 0\n{rows}\n.END\n"
    )


@pytest.mark.parametrize(("formals", "numbers"), [(5, 12), (2, 12), (FORMALS, 30)])
def test_calls_give_every_argument_another_name_and_each_name_as_often(
    formals: int, numbers: int
) -> None:
    calls = arguments(uncalled(formals, numbers))
    assert len(calls) == MOST
    assert all(len(set(call)) == formals for call in calls)
    assert len({tuple(call) for call in calls}) == MOST
    for place in range(formals):
        times = Counter(call[place] for call in calls)
        assert set(times.values()) == {MOST // min(numbers, MOST)}


def test_all_calls_are_proposed_where_they_are_few() -> None:
    assert sorted(arguments(uncalled(2, 3))) == sorted(
        [f"n{i}", f"n{j}"] for i in range(3) for j in range(3) if i != j
    )


@pytest.mark.parametrize(("formals", "numbers"), [(FORMALS, FORMALS - 1), (1, 0), (40, 40)])
def test_no_call_is_proposed_with_too_few_names_or_too_many_arguments(
    formals: int, numbers: int
) -> None:
    assert steps(uncalled(formals, numbers)) == []


def test_places_are_given_where_the_program_goes_and_numbers_elsewhere() -> None:
    text = uncalled(3, 2).replace("TYPE f0", "MOVE f1") + (
        ".LOCATIONS\na 900 0 0 90 90 0\nb 900 9 0 90 90 0\n.END\n"
    )
    calls = arguments(text)
    assert len(calls) == 4
    assert {call[1] for call in calls} == {"a", "b"}
    assert {frozenset((call[0], call[2])) for call in calls} == {frozenset(("n0", "n1"))}


def test_of_many_programs_that_nobody_calls_not_all_are_proposed() -> None:
    assert len(steps(uncalled(2, 12, programs=50))) == ALL


def test_elements_are_proposed_between_near_ones_and_beside_the_ends() -> None:
    assert elements(2, 5) == [f"SET w[{k}] = idle0" for k in (1, 3, 4, 6)]
    assert elements(0, 0) == ["SET w[1] = idle0"]
    assert len(elements(1, 2 + WIDEST)) == WIDEST + 2


def test_no_subscript_makes_proposals_without_end() -> None:
    far = 2**36  # as exact as numbers are
    assert elements(1, far) == [f"SET w[{k}] = idle0" for k in (0, far + 1)]
    assert len(elements(*range(0, 400, 4), idle=20)) == ALL


@pytest.mark.parametrize(
    "step",
    ["SPEED 4 IPS ALWAYS", "SPEED 4 IPS", "SPEED fast[1]", "SPEED 2*pace ALWAYS", "SPEED 5"],
)
def test_a_speed_that_may_be_meant_is_no_slip(step: str) -> None:
    assert list(surely(asked(f".PROGRAM main()\n{step}\nMOVE a\n.END\n"))) == []


def test_what_is_no_speed_is_no_slip() -> None:
    text = ".PROGRAM main()\nACCEL 3\nDURATION 2 ALWAYS\nMOVE a\n.END\n"
    written = asked(text, "vplus")
    assert len(written.steps) == 3
    assert list(surely(written)) == []


@pytest.mark.parametrize(
    ("others", "meant"),
    [
        ("SPEED 200 MMPS ALWAYS", "30"),
        ("SPEED 80 ALWAYS", "80"),
        ("SPEED 80", "30"),
        ("SPEED 2*70 ALWAYS", "30"),
        ("SPEED 20 ALWAYS\nSPEED 60 ALWAYS\nSPEED 70 ALWAYS", "60"),
    ],
)
def test_a_speed_that_crawls_is_meant_as_those_of_its_kind(others: str, meant: str) -> None:
    found = surely(asked(f".PROGRAM main()\n{others}\nSPEED 3 ALWAYS\nMOVE a\n.END\n"))
    assert [(each.change.old, each.change.new) for each in found] == [("3", meant)]


def turned(body: str) -> float:
    """Return what speaks against the other sign of a number that a program is given."""
    text = (
        ".PROGRAM main()\nCALL put(spot, -100)\n.END\n"
        f".PROGRAM put(place, far)\nMOVE place\n{body}\n.END\n"
        ".LOCATIONS\nspot 900 0 0 90 90 0\n.END\n"
    )
    changes = [each for each in other_numbers(asked(text)) if each.change.old == "-100"]
    return min(each.cost for each in changes if each.change.new == "100")


@pytest.mark.parametrize("step", ["DEPARTS far", "APPRO place, far"])
def test_a_distance_to_leave_by_has_the_wrong_sign_and_no_other_number(step: str) -> None:
    shift = turned("MOVES SHIFT(place BY 0,far,0)\nDEPARTS 50")
    assert turned(f"{step}\nDEPARTS 50") == pytest.approx(shift + BACKWARD)
