"""`vrts grade` tells what the laws of likeness are tested for in one process; no mark changes."""

from pathlib import Path

import pytest

from tests.support_commands import vrts_text
from tests.support_likeness.classes import honest, with_copies
from tests.support_likeness.copying.copies import EARLIER
from tests.support_likeness.grading import compared, graded
from tests.support_likeness.judging import groups_in, placed, ranks, told
from vrts.marking.layout import Layout


@pytest.mark.thorough
def test_a_marked_class_has_the_groups_of_one_that_is_compared_alone(tmp_path: Path) -> None:
    old = honest("cans", 1, 8, "before")
    whole = honest("cans", 2, 12, "marked")
    whole = with_copies(whole, ("names", EARLIER), "marked", earlier=old, corpus="before")
    assert [one.kind for one in whole.planted] == ["names", EARLIER]
    found = graded(whole, tmp_path, (("before", old),), "--no-collisions")
    places = placed(whole.planted, found.groups)
    assert ranks(places) == [1, 2], told(places)
    assert found.groups == compared(whole, (("before", old),))

    layout = Layout(tmp_path / "out")
    marks = [path.read_bytes() for path in (layout.results, layout.staff / "marks.csv")]
    again = vrts_text("grade", "similarity", tmp_path / "out")
    assert again.returncode == 0, again.stderr
    alone = groups_in(layout.staff / "similarity.json")
    assert alone == compared(whole)
    assert alone != found.groups
    assert [path.read_bytes() for path in (layout.results, layout.staff / "marks.csv")] == marks
