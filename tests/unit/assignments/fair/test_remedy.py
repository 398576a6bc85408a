"""What to exclude: the values that make a variant fall out, as `task.toml` takes them."""

from tests.unit.assignments.fair.support import variants
from vrts.assignments.fair.remedy import as_toml, cause, fewest, has, narrowed
from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.check.variants.model import Combination, Variants
from vrts.check.variants.section import read_variants


def blocked(one: Combination) -> bool:
    """Return whether the first and the third value are both 1."""
    return one[0] == one[2] == 1


def test_the_cause_is_what_cannot_be_left_away() -> None:
    tried: list[Combination] = []

    def falls_out(one: Combination) -> bool:
        tried.append(one)
        return blocked(one)

    found = cause((1, 2, 1, 3), (0, 0, 0, 0), falls_out, lambda _: True)
    assert found == ((0, 1), (2, 1))
    assert len(tried) == 4  # one for each value


def test_what_no_student_may_get_is_not_tried() -> None:
    def allowed(one: Combination) -> bool:
        return one[1] != 0

    def falls_out(one: Combination) -> bool:
        assert allowed(one)
        return blocked(one)

    assert cause((1, 2, 1), (0, 0, 0), falls_out, allowed) == ((0, 1), (1, 2), (2, 1))


def test_a_variant_that_is_all_right_is_not_excluded() -> None:
    found = narrowed(((0, 1),), (1, 2, 1), [(1, 2, 0), (1, 0, 1), (0, 2, 1)])
    assert set(found) > {(0, 1)}
    assert not any(has(one, found) for one in [(1, 2, 0), (1, 0, 1), (0, 2, 1)])
    assert has((1, 2, 1), found)


def test_needless_parts_are_left_out() -> None:
    wide, narrow, other = ((0, 1),), ((0, 1), (1, 2)), ((2, 0),)
    bad = [(1, 2, 1), (1, 0, 1), (0, 0, 0)]
    assert fewest([narrow, other, wide], bad) == (wide, other)


SECTION = """[variants]
assignment = "x"
[[variants.vary]]
name = "a"
set = "scene.objects.can1.at_mm"
choices = [[1, 2], [3, 4.5]]
[[variants.vary]]
name = "b"
set = ["task.goal.1.on", "task.goal.2.on"]
choices = [["p", "q"], ["q", "p"]]
[[variants.vary]]
name = "c"
set = "scene.objects.can1.color"
choices = ["red", "blue"]
"""


def read(text: str) -> Variants:
    top, problems = read_toml(SourceFile("task.toml", text))
    assert top is not None
    found = read_variants(top, problems)
    assert found is not None, problems.in_order()
    return found


def test_an_exclusion_can_be_pasted() -> None:
    usual = read(SECTION)
    part = ((0, 1), (1, 0), (2, 1))
    (table,) = as_toml(usual, [part])
    after = read(f"{SECTION}\n{table}\n")
    assert [one for n in range(8) if not after.allowed(one := after.combination(n))] == [(1, 0, 1)]


def test_single_values_of_one_thing_stand_in_one_table() -> None:
    parts = (((1, 2),), ((0, 1), (1, 1)), ((1, 0),))
    assert list(as_toml(variants([2, 3]), parts)) == [
        "[[variants.without]]\nv1 = [0, 2]",
        "[[variants.without]]\nv0 = [1]\nv1 = [1]",
    ]
