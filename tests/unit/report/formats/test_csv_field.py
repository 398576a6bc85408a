"""Tables are opened in spreadsheets: foreign texts stay texts there, and numbers stay numbers."""

import pytest

from vrts.report.formats.csv_field import text_field


@pytest.mark.parametrize(
    ("text", "field"),
    [
        ("can1", "can1"),
        ("", ""),
        ("a-b", "a-b"),
        ("=1+1", "'=1+1"),
        ("+1", "'+1"),
        ("-1", "'-1"),
        ("@A1", "'@A1"),
        ("  =1", "'  =1"),
        ("\uff1d1", "'\uff1d1"),
        ("\t=1", '"\'\t=1"'),
        ("\r=1", '"\'\r=1"'),
        ('=HYPERLINK("x")', '"\'=HYPERLINK(""x"")"'),
        ("a,b", '"a,b"'),
        ("a;=1", '"a;=1"'),
    ],
)
def test_a_text_that_would_be_a_formula_is_marked_as_text(text: str, field: str) -> None:
    assert text_field(text) == field
