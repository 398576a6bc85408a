"""A diagnostic as a workflow command of GitHub, which shows it beside the line it is about.

`::error file=pick.v2,line=3,col=9,endLine=3,endColumn=18,title=V302 joint-speed::joint 5 …`
"""

from pathlib import PurePath

from vrts.base.diagnostic import Diagnostic, Severity
from vrts.base.source import Span
from vrts.report.plain import visible
from vrts.report.screen.diagnostic_words import diagnostic_words

COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "notice"}


def workflow_command(d: Diagnostic, name: str) -> str:
    """Return one line; without a place in the text it names the file only."""
    place = _place(d.primary.span) if d.primary else {"file": _file(name)}
    properties = {**place, "title": f"{d.rule.code} {d.rule.slug}"}
    written = ",".join(f"{key}={_property(value)}" for key, value in properties.items())
    return f"::{COMMANDS[d.severity]} {written}::{_data(diagnostic_words(d))}"


def _place(span: Span) -> dict[str, str]:
    source = span.source
    end = max(span.start, span.end)
    first, last = span.line, source.line_of(end)
    place = {"file": _file(source.name), "line": str(first), "endLine": str(last)}
    if first == last:  # columns are refused where the lines differ
        place |= {"col": str(span.column), "endColumn": str(source.column_of(end))}
    order = ("file", "line", "col", "endLine", "endColumn")
    return {key: place[key] for key in order if key in place}


def _file(name: str) -> str:
    return PurePath(name).as_posix()


def _data(text: str) -> str:
    """Return text as the message of a command."""
    return visible(text).replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    """Return text as the value of a property."""
    return _data(text).replace(":", "%3A").replace(",", "%2C")
