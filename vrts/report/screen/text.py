"""Diagnostics for a terminal, in rustc's manner."""

from vrts.base.diagnostic import Diagnostic, Moment
from vrts.report.plain import one_line
from vrts.report.quantities import joint_degrees, when
from vrts.report.screen.excerpt import blocks, excerpt, gutter_width
from vrts.report.screen.palette import BY_SEVERITY, Palette, Style, worded


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
