"""Marking again: the same programs have the same results, and any difference is named."""

import msgspec
import pytest

from tests.unit.marking.appeals.support import BAD, GOOD, TASK, result
from vrts.marking.differences import differences
from vrts.marking.layout import Layout
from vrts.marking.marking import Done, Entry, mark_class
from vrts.marking.result import Kind
from vrts.marking.sample import STAFF, sampled, verify_sample
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place

ENTRIES = (
    Entry("anna", "pick.v2", GOOD),
    Entry("ben", "ben.v2", BAD),
    Entry("cara", "", None, Kind.MISSING, "nothing was handed in"),
)


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> tuple[Marker, tuple[Done, ...]]:
    """Return three submissions, marked with pages."""
    layout = Layout(tmp_path_factory.mktemp("out"))
    marker = Marker(Place(str(TASK)), Wanted(pages=True))
    return marker, tuple(mark_class(marker, ENTRIES, layout, jobs=2))


@pytest.mark.thorough
def test_marking_again_gives_the_same(marked: tuple[Marker, tuple[Done, ...]]) -> None:
    assert verify_sample(*marked, count=10, seed=1, jobs=2) == ()


@pytest.mark.thorough
def test_a_result_that_is_not_the_same_is_told(marked: tuple[Marker, tuple[Done, ...]]) -> None:
    marker, done = marked
    changed = [
        one._replace(result=msgspec.structs.replace(one.result, mark=9.9))
        if one.entry.identifier == "ben"
        else one
        for one in done
    ]
    (unlike,) = verify_sample(marker, changed, count=10, seed=1, jobs=2)
    assert (unlike.identifier, unlike.whose) == ("ben", STAFF)
    ben = next(one for one in done if one.entry.identifier == "ben")
    assert unlike.first == ("mark", "9.9", f"{ben.result.mark}")


def test_a_sample_depends_on_its_seed_alone(marked: tuple[Marker, tuple[Done, ...]]) -> None:
    _, done = marked
    many = [done[0]._replace(entry=Entry(f"s{k:02d}", "s.v2", GOOD)) for k in range(40)]
    some = sampled(many, 5, 7)
    assert len({one.entry.identifier for one in some}) == 5
    assert sampled(many[::-1], 5, 7) == some
    assert sampled(many, 5, 8) != some
    assert len(sampled(many, 100, 7)) == 40
    assert not sampled([one for one in done if one.entry.data is None], 5, 7)


def test_differences_name_the_place_and_both_values() -> None:
    old = result()
    loss = msgspec.structs.replace(old.losses[0], points=2.0)
    new = msgspec.structs.replace(old, mark=7.0, losses=(loss, loss), key=64 * "b")
    found = list(differences(old, new, without=("key",)))
    assert [f.path for f in found][:2] == ["mark", "losses[0].points"]
    assert found[0] == ("mark", "8.5", "7.0")
    assert found[-1].path == "losses[1]"
    assert found[-1].old == "nothing"
    assert found[-1].new.endswith("…")
    assert list(differences(old, old)) == []
