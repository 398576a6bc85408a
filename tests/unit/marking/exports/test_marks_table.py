"""marks.csv: read back by the standard library and by ourselves; no field is a formula."""

import csv
import io
import re
from fractions import Fraction

import pytest
from hypothesis import given as of_any

from tests.support_exports import HOSTILE, given, hostile, row, rows
from vrts.base.source import SourceFile
from vrts.base.written_numbers import parsed
from vrts.marking.exports.given import Options
from vrts.marking.exports.marks_table import COLUMNS, marks_csv, marks_table
from vrts.marking.intake.tables.table_text import table
from vrts.marking.row import Change, Class, Lateness, Row, unsafe_first

NUMBERS = ("mark", "deduction", "change", "final", "lowest", "line", "duration_s", "contacts")


def read(data: bytes, delimiter: str = ",") -> list[dict[str, str]]:
    text = data.decode("utf-8-sig")
    return list(csv.DictReader(io.StringIO(text, newline=""), delimiter=delimiter, strict=True))


def test_a_line_tells_marks_and_why() -> None:
    late, change = Lateness(3600, "1/3", "1 h late"), Change("-1/2", "seen", "R. Huber", "2026-1-1")
    ((_, data),) = marks_table(given([row(late=late, change=change)]), Options()).files
    (line,) = read(data)
    assert tuple(line) == COLUMNS
    assert [line[name] for name in NUMBERS] == [
        "8.5", "0.333333", "-0.5", "7.7", "", "17", "12.5", "1"
    ]  # fmt: skip
    assert (line["status"], line["late"], line["changed by"]) == ("graded", "1 h late", "R. Huber")


def test_columns_of_before_keep_their_places() -> None:
    """Some scripts read by place: what is new comes behind."""
    assert COLUMNS[:13] == (
        *("id", "name", "email", "login", "ids", "file", "received", "status", "mark"),
        *("deduction", "change", "final", "lowest"),
    )
    assert COLUMNS[-6:] == ("key", "unsafe", "items", "comments", "variant", "why")


def test_with_semicolons_numbers_have_a_comma() -> None:
    (line,) = read(marks_csv(Class("vrts.class/1", "L", (row(),)), ";"), ";")
    assert line["final"] == "8,5"


@pytest.mark.parametrize("delimiter", [",", ";"])
@of_any(found=rows())
def test_the_marks_of_any_class_come_back(delimiter: str, found: tuple[Row, ...]) -> None:
    data = marks_csv(Class("vrts.class/1", "L", found), delimiter)
    lines = read(data, delimiter)
    ordered = unsafe_first(found)
    assert [line["id"] for line in lines] == [one.id for one in ordered]
    for line, one in zip(lines, ordered, strict=True):
        assert parsed(line["final"]) == one.exact_final
        assert parsed(line["mark"]) == one.result.exact_mark
        if one.late is not None:
            written = parsed(line["deduction"])
            assert written is not None
            assert abs(written - Fraction(one.late.deduction)) < Fraction(1, 10**6)
    source = SourceFile("marks.csv", data.decode("utf-8-sig").replace("\r\n", "\n"))
    ours = table(source, COLUMNS)
    assert all(len(cells) == len(COLUMNS) for cells in ours)
    assert len(ours) == len(found) + 1


@pytest.mark.parametrize("delimiter", [",", ";"])
def test_no_field_is_a_formula(delimiter: str) -> None:
    found = tuple(hostile(words, n) for n, words in enumerate(HOSTILE))
    for line in read(marks_csv(Class("vrts.class/1", "L", found), delimiter), delimiter):
        for name, text in line.items():
            if name in NUMBERS:
                assert re.fullmatch(r"(-?\d+([.,]\d+)?)?", text)
            else:
                assert not text.lstrip(" ").startswith(("=", "+", "-", "@", "\t", "\r", "\n"))
            assert "\x00" not in text
