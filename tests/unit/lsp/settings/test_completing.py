"""Keys and values of scene and task files, proposed and explained where the cursor stands (`|`)."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vrts.lsp.settings.completing import Completed, complete_setting, explain_setting
from vrts.schemas import KINDS, kind_of


def at(text: str, kind: str, bodies: tuple[str, ...] = ()) -> tuple[Completed, str]:
    offset = text.index("|")
    plain = text.replace("|", "")
    found = complete_setting(plain, kind, offset, bodies)
    return found, plain[found.start : found.end]


def texts(text: str, kind: str, bodies: tuple[str, ...] = ()) -> list[str]:
    return [one.text for one in at(text, kind, bodies)[0].proposals]


def test_tables_are_proposed_as_they_are_written() -> None:
    assert {"[task]", "[[goal]]", "[time]"} <= set(texts("|", "task"))
    assert "[[goal]]" not in texts("[ta|]", "task")
    assert "goal" in texts("[[g|]]", "task")
    assert "task" not in texts("[[g|]]", "task"), "no list of tables"
    assert "time" not in texts("[time]\n\n[t|]", "task"), "it is there already"


def test_keys_are_proposed_with_a_value_and_only_those_that_are_not_given() -> None:
    found = texts('[[goal]]\nobject = "can1"\n|\non = "x"\n[time]\nt_max_s = 3\n', "task")
    assert "position_mm = 10.0" in found
    assert not [text for text in found if text.startswith(("object", "on ", "t_max"))]
    assert "position_mm" in texts("[[goal]]\npos|ition_mm = 3\n", "task"), "its value stays"


@pytest.mark.parametrize(
    ("text", "kind", "wanted", "word"),
    [
        ('[objects.can1]\nkind = "c|"\n', "scene", '"can"', '"c"'),
        ("[[goal]]\nsymmetry = |\n", "task", '"upright"', ""),
        ("[prove]\nhidden = t|\n", "task", "true", "t"),
        ('[[goal]]\nobject = "|', "task", '"can1"', '"'),
        ('[[goal]]\nplace = [\n  { on = "|" },\n]\n', "task", '"can1"', '""'),
    ],
)
def test_values_are_proposed(text: str, kind: str, wanted: str, word: str) -> None:
    found, replaced = at(text, kind, ("can1", "base2"))
    assert wanted in [one.text for one in found.proposals]
    assert replaced == word


def test_inside_tables_in_lines_and_long_texts_the_place_is_right() -> None:
    inside = texts('[[goal]]\nplace = [\n  { on = "a", | },\n]\n', "task")
    assert "at_mm = []" in inside
    assert "position_mm = 10.0" not in inside
    assert texts('[task]\ndescription = """\n[[goal]]\n|\n"""\n', "task") == []
    assert "[[goal]]" not in texts("[objects.can1]\n|", "scene")
    assert "radius_mm = 0" in texts("[objects.can1]\n|", "scene"), "whatever the object is called"


def test_what_a_key_means_is_told_with_its_bounds() -> None:
    text = '[[goal]]\nposition_mm = 10\nobject = "can1"\nnosuch = 1\n'
    found = explain_setting(text, "task", text.index("position"))
    assert found is not None
    assert "above 0 to 10000" in found.text
    assert text[found.start : found.end] == "position_mm"
    assert explain_setting(text, "task", text.index("nosuch")) is None
    of_value = explain_setting(text, "task", text.index("can1"))
    assert of_value is not None
    assert of_value.text.startswith("**object**")


def test_kinds_are_told_by_names() -> None:
    assert kind_of("/a/b/scene.toml") == "scene"
    assert kind_of("gripper-slips-scenario.toml") == "scenario"
    assert kind_of("lesson.toml") is None


@given(st.text("[]{}=\"'#\n,. ab1", max_size=60), st.integers(0, 60), st.sampled_from(KINDS))
def test_no_text_is_too_odd(text: str, offset: int, kind: str) -> None:
    found = complete_setting(text, kind, offset)
    assert 0 <= found.start <= found.end <= len(text)
    explain_setting(text, kind, offset)
