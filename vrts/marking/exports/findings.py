"""SARIF of a class: what compiler, run and checks said of every submission, for those who mark."""

from collections.abc import Iterable

from vrts.base.diagnostic import Diagnostic, Label, Rule
from vrts.base.source import SourceFile, Span
from vrts.marking.exports.given import Given, Options, Product
from vrts.marking.result import Finding
from vrts.marking.row import Row
from vrts.report.formats.json_text import json_text
from vrts.report.formats.sarif import sarif
from vrts.report.plain import bare_name

NAME = "findings.sarif"
MOST = 25_000  # results of a run that code hosts take
LAST_LINE, LAST_COLUMN = 100_000, 10_000  # of places that are told


def findings(given: Given, options: Options) -> Product:
    """Return one log for the class; files are named `ID/program`."""
    del options
    found = [pair for row in given.whole.rows for pair in _of(row)]
    return Product([(NAME, json_text(sarif(found[:MOST])).encode() + b"\n")])


def _of(row: Row) -> Iterable[tuple[str, Diagnostic]]:
    program = row.result.program
    name = row.id if program is None else f"{row.id}/{bare_name(program.name)}"
    source = _places(name, row.result.findings)
    for finding in row.result.findings:
        rule = Rule(finding.code, finding.slug)
        label = None
        if finding.line is not None and finding.line <= LAST_LINE:
            at = source.line_starts[finding.line - 1] + _column(finding) - 1
            label = Label(Span(source, at, at))
        yield (
            name,
            Diagnostic(rule, finding.severity, finding.headline, label, help=finding.help),
        )


def _places(name: str, found: Iterable[Finding]) -> SourceFile:
    """Return a text of blanks that has every place of the findings.

    A result keeps lines and columns, not the program.
    """
    widths: dict[int, int] = {}
    for finding in found:
        if finding.line is not None and finding.line <= LAST_LINE:
            widths[finding.line] = max(widths.get(finding.line, 0), _column(finding))
    lines = (" " * widths.get(line, 0) for line in range(1, max(widths, default=0) + 1))
    return SourceFile(name, "\n".join(lines))


def _column(finding: Finding) -> int:
    return min(max(1, finding.column or 1), LAST_COLUMN)
