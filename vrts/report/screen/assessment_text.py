"""An assessment for a terminal."""

from vrts.report.assessment import Assessment
from vrts.report.ordering import in_order
from vrts.report.screen.first_screen_text import first_screen_text
from vrts.report.screen.palette import Palette
from vrts.report.screen.text import diagnostic_text

MOST_FINDINGS = 20  # of an assessment on a terminal


def assessment_text(a: Assessment, *, color: bool) -> str:
    """Return the first screen of an assessment, then every finding; no line end at the end."""
    parts = [first_screen_text(a, Palette(color=color))]
    findings = in_order(a.findings)
    parts += [diagnostic_text(d, color=color) for d in findings[:MOST_FINDINGS]]
    if len(findings) > MOST_FINDINGS:
        parts.append(f"{len(findings) - MOST_FINDINGS} more findings are not shown here")
    return "\n\n".join(parts)
