"""One line for one diagnostic: `pick.v2:3:9: error[V302 joint-speed] joint 5 exceeds …`."""

from vrts.base.diagnostic import Diagnostic
from vrts.report.plain import line_start, one_line
from vrts.report.screen.excerpt import place
from vrts.report.screen.palette import BY_SEVERITY, Palette, Style


def concise(d: Diagnostic, name: str, *, color: bool = False) -> str:
    """Return the line; without a place in the text it begins with the name of the file."""
    palette = Palette(color=color)
    where = place(d.primary.span) if d.primary else one_line(name)
    rule = f"{d.severity.value}[{d.rule.code} {d.rule.slug}]"
    parts = [
        palette.paint(Style.STRONG, line_start(where)) + ":",
        palette.paint(BY_SEVERITY[d.severity], rule),
        one_line(d.headline),
    ]
    return " ".join(parts)
