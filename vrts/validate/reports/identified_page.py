"""What is wrong with a robot as one HTML page: the sentence, the causes, and what is not known."""

from collections.abc import Sequence

from vrts.base.units import DEG, MM
from vrts.report.page.document import document
from vrts.report.page.html import Child, Markup, element
from vrts.report.plain import capital, one_line
from vrts.validate.identify.identified import Identified, Number, Remaining
from vrts.validate.identify.words import decimals, name_of, unit_of
from vrts.validate.reports.identified_text import OWN_RESTS, sentence, untold

STYLE = "report/validation.css"
SYNTHETIC = "synthetic: made by a computer, not by a real robot"
METHOD = (
    "The program is executed again by a robot with other numbers, and its log compared with this"
    " one. The cause that explains most is taken first, then the next, as long as each is worth"
    " it. Between stands an interval of 95 %: it speaks of these causes only. A gear that is out of"
    " round or a bent link leaves a pattern, and the sentence says that the model does not fit."
)


def identified_page(found: Identified, name: str) -> str:
    """Return the page.

    Args:
        found: What was identified.
        name: Of the program, as shown.
    """
    where = f"log {one_line(found.log)} · {found.rows:,} rows · {found.arm.title}"
    body: list[Child] = [
        element(
            "header",
            element(
                "div",
                element("h1", f"{one_line(name)}: what is wrong with the robot"),
                element("p", where, class_="where"),
                element("p", element("b", capital(SYNTHETIC)), class_="synthetic")
                if found.synthetic
                else None,
                element("p", element("b", capital(sentence(found)))),
                element("p", capital(OWN_RESTS)) if found.own_rests else None,
            ),
            class_="first-screen",
        ),
        element("section", element("h2", "What is off"), _causes(found)),
        element(
            "section",
            element("h2", "What this log cannot tell"),
            element("ul", *(element("li", line) for line in untold(found))),
        ),
        element("section", element("h2", "What is left over"), _left(found.remaining)),
        element("section", element("h2", "How it was found"), element("p", METHOD)),
        element("footer", element("p", "Written by vrts")),
    ]
    return document(f"{one_line(name)}: identified", STYLE, body, ())


def _causes(found: Identified) -> Markup:
    rows = [_cells(number) for number in found.numbers]
    half = "" if found.own_rests else f"± {found.clock_half_s:.4f}"
    rows.append(("clock at the start of the log [s]", f"{found.clock_s:+.4f}", half))
    return _table(("cause", "off by", "95 % between"), rows)


def _cells(number: Number) -> tuple[str, str, str]:
    unit = unit_of(number.cause.kind)
    digits = max(decimals(number.half / unit.size), 2)
    value, low, high = (v / unit.size + 0.0 for v in (number.value, number.low, number.high))
    return (
        f"{name_of(number.cause)} [{unit.name}]",
        f"{value:+.{digits}f}",
        f"{low:+.{digits}f} and {high:+.{digits}f}",
    )


def _left(remaining: Sequence[Remaining]) -> Markup:
    rows: list[tuple[str, ...]] = []
    for r in remaining:
        unit, name = (DEG, "deg") if r.joint else (MM, "mm")
        numbers = (f"{value / unit:.4f}" for value in (r.before, r.after, r.patterned))
        rows.append((f"{r.name} [{name}]", *numbers))
    return _table(("RMS of", "clock alone", "with causes", "pattern"), rows)


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> Markup:
    return element(
        "div",
        element(
            "table",
            element("tr", *(element("th", cell) for cell in head)),
            *(element("tr", *(element("td", cell) for cell in row)) for row in rows),
            class_="rehearsed",
        ),
        class_="scroll",
    )
