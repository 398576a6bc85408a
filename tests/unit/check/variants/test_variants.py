"""What varies in a task, as a teacher writes it: read, drawn, and written into the files."""

import tomllib
from collections import Counter
from dataclasses import replace

import pytest

from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.check.variants.drawn import drawn, variant
from vrts.check.variants.files import name_findings, path_findings, varied, without_names
from vrts.check.variants.model import Variants
from vrts.check.variants.section import read_variants, toml_text

TASK = """\
[task]
scene = "scene.toml"

[[goal]]
on = "base1"  # the left one

[[goal]]
on = "base2"

# Secret: what students may get.
[variants]
assignment = "lab1"
staff_names = ["Can1_Grip"]

[[variants.vary]]
name = "x"
set = ["scene.objects.can1.at_mm.x", "scene.locations.above.1"]
from = 0.1
to = 0.7
step = 0.2
plus = [0, 100]

[[variants.vary]]
name = "goals"
set = ["task.goal.1.on", "task.goal.2.on"]
choices = [["base1", "base2"], ["base2", "base1"]]

[[variants.vary]]
name = "box"
set = "scene.objects.box"
choices = [true, false]

[[variants.without]]
goals = [["base1", "base2"]]
box = [false]

# Times follow.
[time]
reference_s = 9
"""
SCENE = """\
[objects.can1]
at_mm = [0.1, 200]  # here

[locations]
above = [100.1, 200, 0, 90, 90, 0]
can1_grip = [0, 0, 0, 90, 90, 0]

# In the way.
[objects.box]
at_mm = [5, 5]
"""


def read(task: str = TASK) -> tuple[Variants | None, list[str]]:
    top, problems = read_toml(SourceFile("task.toml", task))
    assert top is not None
    found = read_variants(top, problems)
    told = [d.headline for d in problems.in_order()]
    if found is None:
        return None, told
    return found, told + [d.headline for d in path_findings(found, sources(task))]


def sources(task: str = TASK) -> dict[str, SourceFile]:
    return {"task": SourceFile("task.toml", task), "scene": SourceFile("scene.toml", SCENE)}


def sound() -> Variants:
    found, told = read()
    assert told == []
    assert found is not None
    return found


def test_a_variant_is_written_into_the_files_and_nothing_else_changes() -> None:
    texts = varied(sound(), (3, 1, 1), sources())
    before, after = TASK.split("# Secret")[0], "# Times" + TASK.split("# Times")[1]
    changed = before.replace('"base1"  #', '"base2"  #').replace('"base2"\n', '"base1"\n')
    assert texts["task"] == changed + after
    moved = SCENE.replace("[0.1, 200]", "[0.7, 200]").replace("[100.1,", "[100.7,")
    assert texts["scene"] == moved.split("# In the way")[0]


def test_numbers_of_a_range_are_exact() -> None:
    assert [values[0] for values in sound().varies[0].choices] == ["0.1", "0.3", "0.5", "0.7"]
    assert [values[1] for values in sound().varies[0].choices][2] == "100.5"


def test_names_for_staff_are_not_in_the_scene_of_students() -> None:
    text = without_names(sources()["scene"], sound().staff_names)
    line = 'withheld = ["can1_grip"]  # these places you find and teach yourself\n'
    assert text == line + SCENE.replace("can1_grip = [0, 0, 0, 90, 90, 0]\n", "")
    already = SourceFile("scene.toml", f'withheld = "safe"  # high\n{SCENE}')
    known = 'withheld = ["safe", "can1_grip"]  # high\n'
    assert without_names(already, sound().staff_names) == text.replace(line, known)


def test_one_key_gives_one_student_one_variant() -> None:
    variants = sound()
    first = drawn(variants, b"k" * 32, "moodle 7")
    # worked out once: another scheme would give every student another variant
    assert (first.combination, first.tag) == ((1, 1, 1), "rdxh-hxjd")
    assert first == drawn(variants, b"k" * 32, "moodle 7")
    others = {drawn(variants, bytes([k]) * 32, "moodle 7") for k in range(30)}
    assert len(others) > 5


def test_draws_are_even_and_never_what_is_excluded() -> None:
    variants = sound()
    allowed = [c for k in range(variants.total) if variants.allowed(c := variants.combination(k))]
    assert (variants.total, len(allowed)) == (16, 12)
    count = Counter(drawn(variants, b"k", str(k)).combination for k in range(6000))
    assert sorted(count) == allowed
    expected = 6000 / 12
    squares = sum((n - expected) ** 2 / expected for n in count.values())
    assert squares < 31.3  # chi-square, 11 degrees of freedom: one in a thousand is beyond


def test_the_same_values_have_the_same_tag_and_others_another() -> None:
    variants = sound()
    tags = {variant(variants, variants.combination(k)).tag for k in range(variants.total)}
    assert len(tags) == variants.total


def test_a_tag_tells_nothing_without_the_key_and_stays_when_draws_change_places() -> None:
    variants = sound()
    turned = replace(variants, varies=variants.varies[::-1])
    ours = variant(variants, (3, 1, 0), b"k" * 32).tag
    assert variant(turned, (0, 1, 3), b"k" * 32).tag == ours
    assert ours not in {variant(variants, (3, 1, 0), key).tag for key in (None, b"", b"j" * 32)}
    assert variant(replace(variants, key=b"k" * 32), (3, 1, 0)).tag == ours


def test_names_for_staff_must_be_those_of_the_scene() -> None:
    known = ("above", "can1_grip")
    assert name_findings(sound(), known) == ()
    variants, _ = read(TASK.replace("Can1_Grip", "Can1_Gripp"))
    assert variants is not None
    (found,) = name_findings(variants, known)
    assert "no location `can1_gripp`" in found.headline
    assert (found.help, found.is_error) == (("did you mean `can1_grip`?",), True)
    assert found.primary is not None
    assert found.primary.span.text == '"Can1_Gripp"'


def test_letters_of_all_planes_are_written_as_toml() -> None:
    text = 'a 😀 "quoted" \\ \n \x7f ü'
    assert tomllib.loads(f"a = {toml_text(text)}") == {"a": text}


@pytest.mark.parametrize(
    "text",
    [
        'variants.assignment = "a"\nvariants.vary = [{name = "a", set = "b", choices = [1, 2]}]\n',
        'variants = {assignment = "a", vary = [{name = "a", set = "b.c", choices = [1, 2]}]}\n',
    ],
)
def test_variants_without_a_header_are_refused_since_they_could_not_be_cut(text: str) -> None:
    assert read(text) == (None, ["`variants` needs a header of its own"])


@pytest.mark.parametrize(
    ("before", "after", "told"),
    [
        ("at_mm.x", "at.x", "`scene.objects.can1.at.x`: there is no `at` in objects.can1"),
        ("at_mm.x", "at_mm.z", "`scene.objects.can1.at_mm.z`: objects.can1.at_mm has 2:"),
        ("scene.objects.box", "objects.box", "`objects.box` does not begin with a file"),
        ("scene.objects.box", "staff.goal.1.on", "the task has no staff/task.toml"),
        ("scene.objects.box", "task.task.scene", "is the same in all variants"),
        ("scene.objects.box", "task.mark.total", "is the same in all variants"),
        ('"task.goal.1.on", "', '"task.goal.1.at", "', "there is no `at` in goal.1"),
        ("[true, false]", "[true, false, 2]", "it is a whole table, which is there (true) or not"),
        ("step = 0.2", "step = 0.25", "steps of 0.25 from 0.1 do not end at 0.7"),
        ("step = 0.2\n", "", "a range needs `from`, `to` and `step`: `step` is missing"),
        ("to = 0.7", "to = 0", "the range ends at 0, which is not after 0.1"),
        ("step = 0.2", "step = 0.0001", "the range has 6,001 values"),
        ("plus = [0, 100]", "plus = [0]", "`plus` has 1 numbers, and `set` names 2"),
        ("[true, false]", "[true]", "`choices` has 1: it needs 2 to 1,000"),
        ("[true, false]", "[true, true]", "`box` has the same choice twice"),
        ("[true, false]", "[true, 1979-01-01]", "a choice is text, a number, true or false"),
        ("[true, false]\n", "[true, false]\nto = 3\n", "`box` has `choices`, and `from`"),
        ("choices = [true, false]\n", "", "`box` needs `choices`, or `from`, `to` and `step`"),
        ('["base2", "base1"]]', '["base2"]]', "this choice has 1 values, and `set` names 2"),
        ('name = "box"', 'name = "x"', "two things that vary have the name `x`"),
        ('name = "box"', 'name = "a b"', "invalid name `a b` of what varies"),
        ('"scene.objects.box"', '"scene.objects.can1"', "`box` and `x` set the same value"),
        ("scene.objects.box", "scene.objects.can1.at_mm.1", ".1` and `scene.objects.can1.at_mm.x`"),
        ("scene.objects.box", "task.goal.x.on", "`task.goal.x.on` and `task.goal.1.on` set the"),
        ("box = [false]", "box = [3]", "`box` never has this value"),
        ("box = [false]", "fox = [false]", "unknown key `fox` in `[variants.without 1]`"),
        ("box = [false]", "box = [true, false]\nx = [0.1]", None),
        ('goals = [["base1", "base2"]]\nbox = [false]', "box = [true, false]", "nothing is left"),
        ('assignment = "lab1"\n', "", "`[variants]` needs `assignment`"),
        ('assignment = "lab1"', 'assignment = "a/b"', "`assignment` must be a short name"),
    ],
)
def test_what_is_wrong_is_told(before: str, after: str, told: str | None) -> None:
    text = TASK.replace(before, after, 1)
    assert text != TASK
    found = read(text)[1]
    assert len(found) == (0 if told is None else 1), found
    assert told is None or told in found[0]
