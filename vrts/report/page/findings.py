"""The findings of a page: every diagnostic with its excerpt, moment, notes and help."""

from collections.abc import Sequence

from vrts.base.diagnostic import Diagnostic
from vrts.report.page.buttons import watch_button
from vrts.report.page.html import Markup, MarkupPalette, element, painted, prose
from vrts.report.plain import capital, one_line
from vrts.report.screen.excerpt import excerpt
from vrts.report.screen.text import moment_text

MOST_FINDINGS = 100


def findings_section(findings: Sequence[Diagnostic]) -> Markup | None:
    """Return the findings, in the order given; None when there are none."""
    if not findings:
        return None
    cards = [_finding(number, d) for number, d in enumerate(findings[:MOST_FINDINGS], start=1)]
    more = len(findings) - len(cards)
    rest = element("p", f"{more} more findings are not listed.") if more else None
    return element("section", element("h2", "Findings"), *cards, rest, id="findings")


def _finding(number: int, d: Diagnostic) -> Markup:
    rows = excerpt(d, MarkupPalette(), bare=True)
    text = (
        element("pre", painted("\n".join(rows)), class_="excerpt", tabindex="0") if rows else None
    )
    moment = None
    if d.moment is not None:
        words = capital(moment_text(d.moment))
        moment = element("p", watch_button(d.moment.time_s), " ", words, class_="when")
    head = element(
        "h3",
        element("span", d.severity.value, class_="severity"),
        " ",
        element("code", f"{d.rule.code} {d.rule.slug}", class_="rule"),
        " ",
        prose(one_line(d.headline)),
    )
    notes = [element("p", element("b", "Note: "), prose(note), class_="lines") for note in d.notes]
    helps = [element("p", element("b", "Help: "), prose(text), class_="lines") for text in d.help]
    return element(
        "article",
        *(head, text, moment, *notes, *helps),
        class_=f"finding {d.severity.value}",
        id=f"finding-{number}",
    )
