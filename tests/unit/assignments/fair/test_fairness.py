"""A real task in variants: what can be done, what falls out and why, and what copies earn."""

import shutil
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.assignments.fair import fairness as fairness_of
from vrts.assignments.fair.copied import Copied
from vrts.assignments.fair.covering import Covering
from vrts.assignments.fair.fairness import Fairness, fairness
from vrts.assignments.fair.in_words import fair_findings, fair_lines
from vrts.assignments.fair.trial import Trial
from vrts.assignments.variants.of_task import VariedTask, load_varied
from vrts.base.workers import ALONE
from vrts.check.variants.model import Combination, Variants

LAB = ROOT / "examples" / "08-own-numbers" / "lab1"
COVERING = Covering(((0,), (1,)), 2, 0, 1, thinned=False, given_up=12)
NAMES: tuple[str, ...] = ("Ann", "Ben", "Cleo")
COLOUR = """
[[variants.vary]]
name = "color"
set = "scene.objects.can1.color"
choices = ["red", "green"]
"""
FAR = """
[[variants.vary]]
name = "can1"
set = "scene.objects.can1.at_mm"
choices = [[780, -440], [780, -500], [1040, 170]]
"""


def checked(
    home: Path, varies: str, even: str = "", students: Sequence[Combination] = ((0,),)
) -> tuple[Variants, Fairness]:
    """Return what is found out about the example with other things that vary."""
    folder = home / "lab"
    shutil.copytree(LAB, folder)
    task = folder / "task.toml"
    before = task.read_text("utf-8").partition("[variants]")[0]
    names = 'assignment = "test"\nstaff_names = ["can1_grip"]\n'
    task.write_text(f"{before}[variants]\n{names}{even}{varies}", "utf-8")
    varied = load_varied(folder)
    class_: dict[str, Combination] = dict(zip(NAMES, students, strict=False))
    return varied.variants, fairness(varied, class_, ALONE)


def test_what_cannot_be_done_is_named_with_its_remedy(tmp_path: Path) -> None:
    variants, found = checked(tmp_path, FAR)
    assert not found.fair
    (out,) = found.out
    assert out.combination == (2,)  # the can stands in a base
    assert found.excluded == (((0, 2),),)
    (told,) = fair_findings(variants, found)[:1]
    assert told.rule.code == "V818"
    assert "its values: can1 = [1040, 170]" in told.notes
    lines = list(fair_lines(variants, found))
    assert "[[variants.without]]" in lines
    assert "can1 = [[1040, 170]]" in lines
    assert "  2 can be done and are equally hard; 1 falls out" in lines


def test_uneven_variants_fall_out_by_the_bounds_of_the_task(tmp_path: Path) -> None:
    tight = FAR.replace("scene.objects.can1.at_mm", "task.goal.1.position_mm")
    tight = tight.replace("[[780, -440], [780, -500], [1040, 170]]", "[5, 4.5, 3]")
    variants, found = checked(tmp_path, tight, "even = { accuracy = 0.3 }\n")
    (out,) = found.out
    assert out.combination == (2,)
    assert out.why == ("accuracy of goal 1: 3.0 mm, and the median is 4.5 mm",)
    lines = list(fair_lines(variants, found))
    assert any(line.startswith("  accuracy [mm]    4.5     3.0     5.0   3.") for line in lines)
    assert any(line.startswith("    least 3.0 mm: ") for line in lines)


def test_copies_pay_where_only_a_colour_varies(tmp_path: Path) -> None:
    variants, found = checked(tmp_path, COLOUR, students=((0,), (1,), (1,)))
    assert found.fair
    assert found.copied == (6, 6, 6)
    (told,) = fair_findings(variants, found)
    assert told.rule.code == "V819"
    assert not told.is_error
    assert "6 of 6 pairs" in told.headline
    assert not any("were tried" in line for line in list(fair_lines(variants, found))[1:])
    sample = found._replace(copied=Copied(200, 7, 1560), covering=COVERING, students=0)
    not_tried, unsure = fair_findings(variants, sample)
    assert (not_tried.rule.code, not_tried.is_error, sample.fair) == ("V828", True, False)
    assert (unsure.rule.code, "1,560 pairs" in unsure.notes[0]) == ("V819", True)
    lines = list(fair_lines(variants, sample))
    assert "  200 of the 1,560 pairs of made-up students were tried" in lines
    assert "  1 value or pair is excluded by `[[variants.without]]`" in lines
    assert "  12 values and pairs could not be tried" in lines


def test_the_same_variant_is_tried_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    seen: list[Combination] = []
    usual = fairness_of.tried

    def noted(varied: VariedTask, combination: Combination) -> Trial:
        seen.append(combination)
        return usual(varied, combination)

    monkeypatch.setattr(fairness_of, "tried", noted)
    checked(tmp_path, COLOUR, students=((0,), (1,), (1,)))
    assert seen == [(0,), (1,)]
