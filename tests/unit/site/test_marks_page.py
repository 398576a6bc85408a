"""The page on marks says the numbers by which marks are made."""

import re

from tests.places import ROOT
from vrts.check.rules.scheme import MarkScheme
from vrts.check.task.score import divided

PAGE = (ROOT / "vrts" / "manual" / "understand" / "marks.md").read_text("utf-8")


def row(name: str) -> list[float]:
    cells = re.search(rf"^\| {name} \| (.*) \|$", PAGE, re.M)
    assert cells is not None, name
    return [float(number.replace("−", "-")) for number in re.findall(r"−?\d+(?:\.\d+)?", cells[1])]


def test_the_page_says_what_a_task_has_that_says_nothing() -> None:
    usual = MarkScheme()
    alone, _ = divided(usual, targets=True, vias=False)
    assert row("things in their places") == [usual.targets, alone]
    assert row("via points passed") == [usual.vias]
    assert row("quick enough, with nothing wrong") == [usual.time_bonus]
    assert row("the first contact") == [-usual.first_contact]
    assert row("each further contact") == [-usual.further_contact]
    assert row("all contacts together, at most") == [-usual.contact_cap]
    assert row("a limit of the robot broken, once") == [-usual.broken_limit]
    assert usual.total == 10
    assert f"from {usual.zero_at} times the" in PAGE
