"""Laws of changes by hand: what is written is read again, whatever it says."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from vrts.base.source import SourceFile
from vrts.marking.by_hand.override_text import override_text
from vrts.marking.by_hand.overrides import Override, change_of, read_overrides
from vrts.marking.row import final_mark

WORDS = st.text(st.characters(exclude_categories=["Cs"]), min_size=1, max_size=60).filter(
    lambda text: bool(text.strip())
)
POINTS = st.integers(-10_000, 10_000).map(lambda n: Fraction(n, 1000))
MARKS = st.integers(0, 100).map(lambda n: Fraction(n, 10))


@st.composite
def overrides_of_anybody(draw: st.DrawFn) -> Override:
    """Return a change, of a delta or to a mark."""
    points, to_mark = draw(POINTS), draw(st.booleans())
    delta, mark = (None, abs(points)) if to_mark else (points, None)
    return Override(draw(WORDS), delta, mark, draw(WORDS), draw(WORDS), "2026-11-30")


@given(st.lists(overrides_of_anybody(), max_size=5, unique=True))
def test_what_is_written_is_read_again(overrides: list[Override]) -> None:
    text = "\n".join(map(override_text, overrides))
    found = read_overrides(SourceFile("overrides.toml", text), {o.student for o in overrides})
    plain = [o._replace(reason=o.reason.strip(), who=o.who.strip()) for o in overrides]
    if len(set(plain)) == len(plain):
        assert not found.diagnostics
        for student, changes in found.changes.items():
            assert list(changes) == [o for o in plain if o.student == student]


@given(MARKS, st.lists(POINTS, min_size=1, max_size=4), MARKS)
def test_a_mark_takes_the_place_of_all_before_it(
    before: Fraction, points: list[Fraction], mark: Fraction
) -> None:
    deltas = [Override("anna", p, None, str(p), "RH", "2026-11-30") for p in points]
    last = Override("anna", None, mark, "in the end", "RH", "2026-12-01")
    assert final_mark(before, None, change_of(before, [*deltas, last])) == mark


@given(MARKS, st.lists(POINTS, min_size=1, max_size=4))
def test_deltas_add_up(before: Fraction, points: list[Fraction]) -> None:
    deltas = [Override("anna", p, None, str(p), "RH", "2026-11-30") for p in points]
    change = change_of(before, deltas)
    assert change is not None
    assert Fraction(change.delta) == sum(points)
