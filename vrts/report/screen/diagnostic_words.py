"""Everything a diagnostic says, without its excerpt: what annotations and viewers show."""

from vrts.base.diagnostic import Diagnostic
from vrts.report.plain import one_line, visible
from vrts.report.screen.text import moment_text


def diagnostic_words(d: Diagnostic) -> str:
    """Return headline, label, moment, notes and help on lines of their own; visible text."""
    rows = [one_line(d.headline)]
    if d.primary and d.primary.text.strip():
        rows.append(one_line(d.primary.text))
    if d.moment:
        rows.append(moment_text(d.moment))
    rows += [f"note: {visible(text)}" for text in d.notes]
    rows += [f"help: {visible(text)}" for text in d.help]
    return "\n".join(rows)
