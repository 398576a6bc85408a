"""Diagnostics and assessments for a terminal, in rustc's manner."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from vrts.base.diagnostic import Diagnostic, Moment, Severity
from vrts.report.plain import one_line
from vrts.report.quantities import joint_degrees, when
from vrts.report.screen.excerpt import blocks, excerpt, gutter_width
from vrts.report.screen.palette import BY_SEVERITY, Palette, Style, worded

if TYPE_CHECKING:  # `vrts compile` shows diagnostics and needs no engine
    from vrts.report.assessment import Assessment


MOST_FINDINGS = 20  # of an assessment on a terminal


def diagnostic_text(d: Diagnostic, *, color: bool) -> str:
    """Return a diagnostic with its excerpt, notes and help; no line end at the end."""
    palette = Palette(color=color)
    rule = f"{d.severity.value}[{d.rule.code} {d.rule.slug}]"
    rows = [
        palette.paint(BY_SEVERITY[d.severity], rule)
        + palette.paint(Style.STRONG, f": {one_line(d.headline)}")
    ]
    rows += excerpt(d, palette)
    if d.moment:
        parts = blocks(d.primary, d.secondary)
        indent = " " * ((gutter_width(parts) if parts else 0) + 1)
        rows.append(palette.paint(Style.GUTTER, f"{indent}=") + f" {moment_text(d.moment)}")
    rows += [worded("note", text, Style.STRONG, palette) for text in d.notes]
    rows += [worded("help", text, Style.NOTE, palette) for text in d.help]
    return "\n".join(rows)


def moment_text(moment: Moment) -> str:
    """Return `at 12.4 s: can1 and base1; joints -20 -110 95 0 90 12 deg`."""
    joints = " ".join(f"{value:g}" for value in joint_degrees(moment.configuration))
    parts = [" and ".join(one_line(body) for body in moment.bodies)] if moment.bodies else []
    parts += [f"joints {joints} deg"] if joints else []
    return f"{when(moment)}: {'; '.join(parts)}" if parts else when(moment)


def assessment_text(a: "Assessment", *, color: bool) -> str:
    """Return the first screen of an assessment, then every finding; no line end at the end."""
    from vrts.report.screen.first_screen_text import first_screen_text  # not for `vrts compile`

    parts = [first_screen_text(a, Palette(color=color))]
    findings = in_order(a.findings)
    parts += [diagnostic_text(d, color=color) for d in findings[:MOST_FINDINGS]]
    if len(findings) > MOST_FINDINGS:
        parts.append(f"{len(findings) - MOST_FINDINGS} more findings are not shown here")
    return "\n\n".join(parts)


def in_order(findings: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return findings, errors before warnings before notes; one that comes again is told once."""
    weight = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.NOTE: 2}
    alike: dict[object, list[Diagnostic]] = {}
    for d in findings:
        where = d.primary.span if d.primary else None
        same = alike.setdefault((d.rule, d.headline, where), [])
        if all(d.moment != other.moment for other in same) or not same:
            same.append(d)
    told = [_with_count(same[0], len(same) - 1) for same in alike.values()]
    return sorted(told, key=lambda d: weight[d.severity])


def _with_count(d: Diagnostic, more: int) -> Diagnostic:
    if not more:
        return d
    return replace(d, notes=(*d.notes, f"and {more} more time{'s' if more > 1 else ''}"))
