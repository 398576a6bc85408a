"""Diagnostics and assessments for a terminal, in rustc's manner."""

from collections.abc import Sequence
from typing import TypeAlias

from vrts.base.diagnostic import Diagnostic, Moment, Severity
from vrts.report.assessment import Assessment
from vrts.report.excerpt import blocks, excerpt, gutter_width
from vrts.report.first_screen import FirstScreen, first_screen
from vrts.report.palette import BY_SEVERITY, Palette, Style
from vrts.report.plain import one_line, visible, width
from vrts.report.quantities import at_time, joint_degrees, lost, mark

Row: TypeAlias = tuple[str, str]


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
    rows += [_worded("note", text, Style.STRONG, palette) for text in d.notes]
    rows += [_worded("help", text, Style.NOTE, palette) for text in d.help]
    return "\n".join(rows)


def moment_text(moment: Moment) -> str:
    """Return `at 12.4 s: can1 and base1; joints -20 -110 95 0 90 12 deg`."""
    joints = " ".join(f"{value:g}" for value in joint_degrees(moment.configuration))
    parts = [" and ".join(one_line(body) for body in moment.bodies)] if moment.bodies else []
    parts += [f"joints {joints} deg"] if joints else []
    return f"{at_time(moment.time_s)}: {'; '.join(parts)}" if parts else at_time(moment.time_s)


def assessment_text(a: Assessment, *, color: bool) -> str:
    """Return the first screen of an assessment, then every finding; no line end at the end."""
    palette = Palette(color=color)
    parts = [first_screen_text(a, first_screen(a), palette)]
    parts += [diagnostic_text(d, color=color) for d in in_order(a.findings)]
    return "\n\n".join(parts)


def in_order(findings: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return findings, each once, errors before warnings before notes."""
    weight = {Severity.ERROR: 0, Severity.WARNING: 1, Severity.NOTE: 2}
    once = list({id(d): d for d in findings}.values())
    return sorted(once, key=lambda d: weight[d.severity])


def first_screen_text(a: Assessment, screen: FirstScreen, palette: Palette) -> str:
    """Return the first screen: mark, ready, cause, hint, losses."""
    title = one_line(a.title) + (f" · {one_line(a.task.title)}" if a.task else "")
    good = Style.GOOD if screen.ready else Style.ERROR
    if screen.mark is None:
        rows = [palette.paint(Style.STRONG, title) + f": {screen.status}"]
    else:
        number = palette.paint(good, f"{mark(screen.mark)} / 10")
        rows = [f"{number}  {palette.paint(Style.STRONG, title)} ({screen.status})"]
    rows.append("ready for the real robot: " + palette.paint(good, yes_no(screen.ready)))
    rows += [screen.cause]
    rows += [_worded("hint", screen.hint, Style.NOTE, palette)] if screen.hint else []
    table = _loss_rows(screen) if screen.losses else _verdict_rows(screen)
    return "\n".join([*rows, "", *_table(table, palette)] if table else rows)


def yes_no(affirmative: bool) -> str:
    """Return the word."""
    return "yes" if affirmative else "no"


def _worded(word: str, text: str, style: Style, palette: Palette) -> str:
    first, *rest = visible(text).split("\n")
    indent = " " * (len(word) + 2)
    return "\n".join(
        [palette.paint(style, word) + f": {first}", *(f"{indent}{line}" for line in rest)]
    )


def _loss_rows(screen: FirstScreen) -> list[Row]:
    assert screen.mark is not None
    rows = [(lost(loss.points), one_line(loss.sentence)) for loss in screen.losses]
    return [("points", "lost by"), *rows, (mark(screen.mark), "mark, of 10")]


def _verdict_rows(screen: FirstScreen) -> list[Row]:
    rows = [
        (v.answer.value, f"{one_line(v.check)}: {one_line(v.summary)}") for v in screen.verdicts
    ]
    return [("answer", "check"), *rows] if rows else []


def _table(rows: Sequence[Row], palette: Palette) -> list[str]:
    columns = max(width(left) for left, _ in rows)
    lines = [f"  {' ' * (columns - width(left))}{left}  {right}" for left, right in rows]
    return [palette.paint(Style.FAINT, lines[0]), *lines[1:]]
