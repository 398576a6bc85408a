"""A diagnostic as JSON, with its exact values. Needs nothing but diagnostics."""

from typing import TypeAlias

from vrts.base.diagnostic import Diagnostic, Fix, Label, Moment
from vrts.base.source import Span
from vrts.report.quantities import joint_degrees, millimetres, rounded_data, seconds

Json: TypeAlias = dict[str, object]


def diagnostic_json(d: Diagnostic) -> Json:
    """Return a diagnostic with its exact values."""
    return {
        "code": d.rule.code,
        "slug": d.rule.slug,
        "severity": d.severity.value,
        "headline": d.headline,
        "primary": _label(d.primary) if d.primary else None,
        "secondary": [_label(label) for label in d.secondary],
        "notes": list(d.notes),
        "help": list(d.help),
        "fix": _fix(d.fix) if d.fix else None,
        "moment": moment_json(d.moment) if d.moment else None,
        "data": rounded_data(d.data),
    }


def moment_json(moment: Moment) -> Json:
    """Return time, joints, hand opening and bodies of a moment."""
    hand = moment.configuration[6:7]
    return {
        "time_s": seconds(moment.time_s),
        "joints_deg": joint_degrees(moment.configuration),
        "hand_mm": millimetres(hand[0]) if hand else None,
        "bodies": list(moment.bodies),
    }


def _fix(fix: Fix) -> Json:
    """Return what to replace, and where more has to be replaced with it."""
    more = [{**_span(edit.span), "replacement": edit.replacement} for edit in fix.more]
    first: Json = {**_span(fix.span), "replacement": fix.replacement}
    return {**first, "more": more} if more else first


def _span(span: Span) -> Json:
    source = span.source
    last = max(span.start, span.end)
    return {
        "file": source.name,
        "line": span.line,
        "column": span.column,
        "end_line": source.line_of(last),
        "end_column": source.column_of(last),
    }


def _label(label: Label) -> Json:
    return {**_span(label.span), "text": label.text}
