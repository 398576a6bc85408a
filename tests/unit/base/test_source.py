"""Lines, columns and spans."""

from vrts.base.source import SourceFile, Span


def test_lines_and_columns_count_from_one() -> None:
    source = SourceFile("a.v2", "one\ntwo\n\nfour")
    assert source.line_of(0) == 1
    assert source.line_of(3) == 1  # the line end belongs to its line
    assert source.line_of(4) == 2
    assert source.column_of(6) == 3
    assert source.line_of(len(source.text)) == 4


def test_lines_come_without_their_ends() -> None:
    assert list(SourceFile("a.v2", "one\r\ntwo\n").lines()) == ["one", "two", ""]


def test_a_span_knows_its_text_and_place() -> None:
    span = Span(SourceFile("a.v2", "MOVE a\nMOVES part\n"), 13, 17)
    assert (span.text, span.line, span.column) == ("part", 2, 7)
