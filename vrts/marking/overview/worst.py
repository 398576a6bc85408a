"""What goes wrong most, the slowest programs, and those that touch most."""

from collections.abc import Callable, Sequence

from vrts.marking.overview.figures import Failing, failing
from vrts.marking.overview.links import staff_report
from vrts.marking.overview.words import has_report, tenth, who
from vrts.marking.row import Row
from vrts.report.page.html import Markup, element, prose
from vrts.report.plain import one_line
from vrts.report.quantities import MINUS, points

MOST = 8  # rows of each list
MOST_CHECKS = 16


def checks(rows: Sequence[Row]) -> Markup | None:
    """Return the checks that fail most; None where none does."""
    found = failing(rows)
    if not found:
        return None
    heads = ("Check", "Fails", "Of those asked", "Mean points lost")
    head = element("tr", *(element("th", text, scope="col") for text in heads))
    table = element(
        "table",
        element("thead", head),
        element("tbody", *(_check(f) for f in found[:MOST_CHECKS])),
        class_="failing",
    )
    rest = len(found) - MOST_CHECKS
    return element(
        "section",
        element("h2", "Checks that fail most"),
        table,
        element("p", f"and {rest} more", class_="where") if rest > 0 else None,
        id="checks",
    )


def _check(f: Failing) -> Markup:
    failed = f.violated + f.not_reached
    parts = [("violated", f.violated), ("unreached", f.not_reached), ("doubtful", f.undetermined)]
    bar = element(
        "span",
        *(element("i", class_=c, style=f"width:{100 * n / f.asked:.1f}%") for c, n in parts if n),
        class_="share",
        aria_hidden="true",
    )
    notes = [f"{failed} of {f.asked}"]
    if f.not_reached:
        notes.append(f"{f.not_reached} not reached")
    if f.undetermined:
        notes.append(f"{f.undetermined} undetermined")
    hidden = element("span", "hidden", class_="tag") if f.hidden else None
    lost = f"{MINUS}{points(f.mean_lost)}" if f.mean_lost > 0 else "0.0"
    return element(
        "tr",
        element("td", prose(one_line(f.title)), hidden),
        element("td", bar, element("b", f"{100 * failed / f.asked:.0f} %"), class_="fails"),
        element("td", ", ".join(notes), class_="soft"),
        element("td", lost, class_="number"),
    )


def slowest(rows: Sequence[Row], *, pages: bool) -> Markup | None:
    """Return the programs that took longest."""

    def taken(row: Row) -> float:
        return row.result.metrics.duration_s or 0.0

    def told(row: Row) -> str:
        return f"{taken(row):.1f} s"

    return _list("Slowest programs", "slowest", "Time", rows, taken, told, pages=pages)


def most_contacts(rows: Sequence[Row], *, pages: bool) -> Markup | None:
    """Return the programs that touch most."""

    def touched(row: Row) -> float:
        return float(row.result.metrics.contacts or 0)

    def told(row: Row) -> str:
        return str(row.result.metrics.contacts)

    return _list("Most contacts", "contacts", "Contacts", rows, touched, told, pages=pages)


def _list(
    title: str,
    identifier: str,
    what: str,
    rows: Sequence[Row],
    number: Callable[[Row], float],
    told: Callable[[Row], str],
    *,
    pages: bool,
) -> Markup | None:
    found = sorted((row for row in rows if number(row) > 0), key=lambda row: -number(row))[:MOST]
    if not found:
        return None
    top = number(found[0])
    body = [
        element(
            "tr",
            element("td", who(row, staff_report(row.id) if pages and has_report(row) else None)),
            element("td", _bar(number(row) / top), told(row), class_="fails"),
            element("td", tenth(row.final), class_="number"),
        )
        for row in found
    ]
    heads = ("Submission", what, "Final mark")
    head = element("tr", *(element("th", text, scope="col") for text in heads))
    table = element("table", element("thead", head), element("tbody", *body), class_="toplist")
    return element("section", element("h2", title), table, id=identifier)


def _bar(share: float) -> Markup:
    fill = element("i", style=f"width:{100 * share:.0f}%")
    return element("span", fill, class_="share", aria_hidden="true")
