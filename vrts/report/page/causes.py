"""What led to a loss, as a fold of a page with jumps into the replay."""

from vrts.check.rules.hints import Hints
from vrts.report.page.buttons import watch_button
from vrts.report.page.html import Markup, element, prose
from vrts.report.plain import capital, one_line
from vrts.why.chain import Chain, Link, words


def causes_fold(chain: Chain, level: Hints, *, unfolded: bool) -> Markup | None:
    """Return the links of a chain, what came last first; None where there are none to be told."""
    if not chain.links or level is Hints.NOTHING:
        return None
    rows = [_row(link, level) for link in chain.links]
    return element(
        "details",
        element("summary", "Why"),
        element("ol", *rows),
        class_="why",
        open=unfolded,
    )


def _row(link: Link, level: Hints) -> Markup:
    line = None
    if link.span is not None:
        text = one_line(" ".join(link.span.text.split()))
        where = element("a", f"Line {link.span.line}", href=f"#L{link.span.line}")
        line = element("span", where, " ", element("code", text), class_="at")
    said = element("span", prose(capital(one_line(words(link, level)))), class_="said")
    button = None if link.time_s is None else watch_button(link.time_s)
    return element("li", line, button, said)
