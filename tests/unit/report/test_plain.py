"""Text of anybody, shown: each attack and what becomes of it."""

import pytest

from vrts.report.formats.json_text import json_text
from vrts.report.plain import line_start, plain_text, shown, visible


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("\x1b[31m", "␛[31m"),
        ("a\rb", "a␍b"),
        ("\x7f\x9b\u202e\u2066\ud800\ue000", "␡�����"),
        ("##[error]", "#♯[error]"),
        ("###VSO[task", "##♯VSO[task"),
        ("##teamcity[x", "#♯teamcity[x"),
        ("## #[1] ##a[1]", "## #[1] ##a[1]"),
    ],
)
def test_every_character_that_steers_has_a_stand_in(text: str, expected: str) -> None:
    assert visible(text) == expected
    assert shown(text).text == expected


def test_a_line_that_begins_like_a_command_does_so_no_longer() -> None:
    assert line_start("  ::error::x") == "  ∶:error::x"
    assert line_start("a::b") == "a::b"
    assert plain_text("a\n::error::\r\n ::b") == "a\n∶:error::␍\n ∶:b"


def test_json_is_ascii_without_control_characters() -> None:
    text = json_text({"a": "ö\x7f\x9b\u202e##[x] \\##vso["})
    assert text == '{\n  "a": "\\u00f6\\u007f\\u009b\\u202e#\\u0023[x] \\\\#\\u0023vso["\n}'
