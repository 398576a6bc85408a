"""Diagnostics as SARIF 2.1.0, the format that code hosts and editors read from analysers.

Section numbers are those of the OASIS standard. Names of files become URIs; messages are made
visible, since viewers show them, and carry neither placeholders nor links of the program's making.
"""

from collections.abc import Sequence
from pathlib import PurePath
from typing import TypeAlias
from urllib.parse import quote

from vrts import __version__
from vrts.base.diagnostic import Diagnostic, Fix, Label, Rule, Severity
from vrts.base.source import Span
from vrts.report.formats.diagnostic_json import moment_json
from vrts.report.plain import visible
from vrts.report.quantities import rounded_data
from vrts.report.rule_page import rule_page
from vrts.report.screen.diagnostic_words import diagnostic_words

Json: TypeAlias = dict[str, object]

SCHEMA = (
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"
)
LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.NOTE: "note"}


def sarif(found: Sequence[tuple[str, Diagnostic]]) -> Json:
    """Return one log with one run.

    Args:
        found: Every diagnostic with the name of the file it was found in.
    """
    rules = sorted({d.rule for _, d in found})
    index = {rule: at for at, rule in enumerate(rules)}
    driver: Json = {"name": "vrts", "version": __version__, "rules": [_rule(r) for r in rules]}
    run: Json = {
        "tool": {"driver": driver},
        "invocations": [{"executionSuccessful": True}],
        "columnKind": "unicodeCodePoints",
        "results": [_result(d, name, index[d.rule]) for name, d in found],
    }
    return {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}


def _rule(rule: Rule) -> Json:
    named: Json = {"id": rule.code, "name": rule.slug}
    page = rule_page(rule.code)
    if page is None:
        return named
    return {
        **named,
        "shortDescription": {"text": page.summary},
        "fullDescription": {"text": page.meaning},
        "help": {"text": page.text, "markdown": page.markdown},
    }


def _result(d: Diagnostic, name: str, rule_index: int) -> Json:
    place = _place(d.primary.span) if d.primary else _file(name)
    result: Json = {
        "ruleId": d.rule.code,
        "ruleIndex": rule_index,
        "level": LEVELS[d.severity],
        "message": _message(diagnostic_words(d)),
        "locations": [{"physicalLocation": place}],
    }
    if d.secondary:
        result["relatedLocations"] = [_related(n, label) for n, label in enumerate(d.secondary, 1)]
    if d.fix:
        result["fixes"] = [_fix(d.fix, d.help)]
    properties = _properties(d)
    if properties:
        result["properties"] = properties
    return result


def _properties(d: Diagnostic) -> Json:
    properties: Json = {}
    if d.moment:
        properties["moment"] = moment_json(d.moment)
    if d.data:
        properties["data"] = rounded_data(d.data)
    return properties


def _related(number: int, label: Label) -> Json:
    related: Json = {"id": number, "physicalLocation": _place(label.span)}
    if label.text:
        related["message"] = _message(visible(label.text))
    return related


def _fix(fix: Fix, help_texts: Sequence[str]) -> Json:
    change: Json = {
        **_file(fix.span.source.name),
        "replacements": [
            {
                "deletedRegion": _region(edit.span),
                "insertedContent": {"text": edit.replacement},
            }
            for edit in fix.edits
        ],
    }
    described: Json = {"description": _message(visible(help_texts[0]))} if help_texts else {}
    return {**described, "artifactChanges": [change]}


def _message(text: str) -> Json:
    """Return a plain message: braces doubled (3.11.5), and no link (3.11.6)."""
    return {"text": text.replace("{", "{{").replace("}", "}}").replace("](", "] (")}


def _place(span: Span) -> Json:
    return {**_file(span.source.name), "region": _region(span)}


def _file(name: str) -> Json:
    return {"artifactLocation": {"uri": uri(name)}}


def _region(span: Span) -> Json:
    """Return lines and columns from 1; the end column is that behind the last character."""
    source = span.source
    end = max(span.start, span.end)
    return {
        "startLine": span.line,
        "startColumn": span.column,
        "endLine": source.line_of(end),
        "endColumn": source.column_of(end),
    }


def uri(name: str) -> str:
    """Return the URI of a file: relative to the working folder, or absolute with `file:`."""
    path = PurePath(name)
    encoded = quote(_octets(path.as_posix()), safe="/")
    return (
        f"file://{'' if encoded.startswith('/') else '/'}{encoded}"
        if path.is_absolute()
        else encoded
    )


def _octets(name: str) -> bytes:
    """Return the bytes of a file name; what was no UTF-8 stands in it as lone surrogates."""
    try:
        return name.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:  # surrogates of another origin: Windows has such names
        return name.encode("utf-8", "surrogatepass")
