"""Findings of an earlier text, shown in a later one."""

from vrts.base.diagnostic import Severity
from vrts.base.source import SourceFile
from vrts.lsp.channel.findings import Finding, carried


def test_findings_move_with_their_lines_and_go_when_they_change() -> None:
    old = "one\ntwo\nthree\n"
    finding = Finding("/c/a.v2", "V400", Severity.ERROR, "hits", 4, 7)
    last = finding._replace(start=8, end=13)

    def now(new: str) -> list[str]:
        after = SourceFile("a", new)
        moved = carried((finding, last), SourceFile("a", old), after)
        assert all(f.severity is Severity.NOTE for f in moved)
        assert all(f.message == "before the last change: hits" for f in moved)
        return [after.text[f.start : f.end] for f in moved]

    assert now(old) == ["two", "three"]
    assert now("new\none\ntwo\nthree\n") == ["two", "three"]
    assert now("one\ntwo\nnew\nthree\n") == ["two", "three"]
    assert now("one\ntwo2\nthree\n") == ["three"]
    assert now("three\n") == ["three"]
    assert now("") == []
