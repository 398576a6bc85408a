"""Profiles of controllers: those that come with vrts, and those of users."""

from pathlib import Path

import pytest

from vrts.dispatch import allowed
from vrts.dispatch.profile import find_profile, profile_names
from vrts.dispatch.profile_parts import Commands
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

FOLDER = Path(allowed.__file__).parent / "profiles"


def changed(tmp_path: Path, *changes: tuple[str, str]) -> str:
    """Return the file of a profile with parts of `mark2-val2` replaced."""
    text = (FOLDER / "mark2-val2.toml").read_text()
    for before, after in changes:
        assert before in text
        text = text.replace(before, after)
    path = tmp_path / "mine.toml"
    path.write_text(text)
    return str(path)


def codes(refused: Refused) -> list[str]:
    return [found.rule.code for found in refused.diagnostics]


def test_there_are_four_and_nobody_has_tried_them() -> None:
    names = ("kawasaki-as", "mark2-val2", "mark3-val2", "vplus-serial")
    assert profile_names() == names
    for name in names:
        profile = find_profile(name)
        assert profile.name == name
        assert profile.warning == f"the profile `{name}` was not tried on hardware"


@pytest.mark.parametrize("name", profile_names())
def test_all_that_a_profile_types_is_on_the_list(name: str) -> None:
    commands = find_profile(name).commands
    letters = {"leave", "insert"}
    for key in set(Commands._fields) - letters - {"letters"}:
        text = getattr(commands, key).format(name="a", step=1, formals="(b, $c)")
        assert allowed.permits(text, allowed.Prompt.READY), text
    assert {getattr(commands, key) for key in letters} <= allowed.LETTERS


def test_a_file_of_the_user_counts_as_well(tmp_path: Path) -> None:
    path = changed(tmp_path, ("baud = 9600", "baud = 4800"), ("tried = false", "tried = true"))
    profile = find_profile(path)
    assert profile.serial.baud == 4800
    assert profile.warning == ""
    assert profile.digest != find_profile("mark2-val2").digest


@pytest.mark.parametrize("name", ["mark4", "../profiles/mark2-val2", "", "a" * 200])
def test_a_name_that_is_none_is_told_with_those_there_are(name: str) -> None:
    with pytest.raises(CannotRead) as told:
        find_profile(name)
    assert "kawasaki-as, mark2-val2, mark3-val2, vplus-serial" in told.value.hints[0]


@pytest.mark.parametrize(
    "command",
    [
        "EXECUTE {name}",
        "DO READY",
        "CALIBRATE",
        "ENABLE POWER",
        "EDIT {name}\\rEXECUTE {name}",
        "POINT {name} = HERE",
        "DELETE {name}",
        "ZERO",
        "edit {other}",
        "EDIT {name.__class__}",
    ],
)
def test_no_profile_can_make_vrts_type_anything_else(tmp_path: Path, command: str) -> None:
    path = changed(tmp_path, ('"EDIT {name},{step}"', f'"{command}"'))
    with pytest.raises(Refused) as told:
        find_profile(path)
    assert codes(told.value) == ["V831"]


def test_a_letter_of_the_editor_and_a_control_character_too(tmp_path: Path) -> None:
    path = changed(tmp_path, ('insert = "I"', 'insert = "T"'), ("\\u0015", "\\u0003"))
    with pytest.raises(Refused) as told:
        find_profile(path)
    assert codes(told.value) == ["V831", "V831"]


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (r"(?P<step>[0-9]+)\.\?", r"[0-9]+\.\?"),
        (r"'\.'", r"'(.'"),
        (r"'\.'", r"'\.?'"),
    ],
)
def test_a_pattern_that_cannot_work_is_refused(tmp_path: Path, before: str, after: str) -> None:
    with pytest.raises(Refused) as told:
        find_profile(changed(tmp_path, (before, after)))
    assert codes(told.value) == ["V830"]


def test_what_is_misspelt_or_out_of_range_is_told_in_its_place(tmp_path: Path) -> None:
    with pytest.raises(Refused) as told:
        find_profile(changed(tmp_path, ("[printed]", "[print]")))
    assert codes(told.value) == ["V602"]
    path = changed(
        tmp_path,
        ("baud = 9600", "baud = 3"),
        ('parity = "none"', 'parity = "mark"'),
        ("reply_s", "replies_s"),
        ("tried = false", ""),
    )
    with pytest.raises(Refused) as told:
        find_profile(path)
    assert sorted(codes(told.value)) == ["V602", "V603", "V605", "V606"]
