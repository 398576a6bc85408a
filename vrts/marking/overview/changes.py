"""Marks that are not as computed: late, or changed by hand, with the computed mark beside."""

from collections.abc import Sequence
from fractions import Fraction

from vrts.marking.by_hand.decisions.words import due_words
from vrts.marking.overview.links import staff_report
from vrts.marking.overview.words import NONE, has_report, signed, tenth, who
from vrts.marking.row import Decided, Lateness, Row
from vrts.report.page.html import Markup, element
from vrts.report.plain import one_line

FIRST = 12  # shown at once
HEADS = ("Submission", "Computed", "Late", "Changed by hand", "Final mark")


def changes(rows: Sequence[Row], *, pages: bool) -> Markup | None:
    """Return the table; None where every mark is as computed."""
    found = [
        row for row in rows if _is_late(row) or row.change is not None or row.decided is not None
    ]
    if not found:
        return None
    rest = found[FIRST:]
    more = element("summary", f"{len(rest)} more")
    return element(
        "section",
        element("h2", "Late and changed marks"),
        _table(found[:FIRST], pages=pages),
        element("details", more, _table(rest, pages=pages)) if rest else None,
        id="changes",
    )


def _is_late(row: Row) -> bool:
    return row.late is not None and not row.late.untimed


def _table(rows: Sequence[Row], *, pages: bool) -> Markup:
    head = element("tr", *(element("th", text, scope="col") for text in HEADS))
    body = [_row(row, pages=pages) for row in rows]
    return element("table", element("thead", head), element("tbody", *body), class_="changes")


def _row(row: Row, *, pages: bool) -> Markup:
    link = staff_report(row.id) if pages and has_report(row) else None
    _, computed, late, changed, final = HEADS  # told beside each cell where the screen is narrow
    return element(
        "tr",
        element("td", who(row, link)),
        element("td", tenth(row.result.mark), class_="number", data_head=computed),
        element("td", *_late(row.late), data_head=late),
        element("td", *_change(row), data_head=changed),
        element("td", element("b", tenth(row.final)), class_="number", data_head=final),
    )


def _late(late: Lateness | None) -> tuple[str | Markup, ...]:
    if late is None:
        return (NONE,)
    if late.review:
        return (element("span", "not known"), element("small", one_line(late.sentence)))
    deduction = Fraction(late.deduction)
    cost = element("b", signed(-deduction)) if deduction else element("span", "costs nothing")
    return (cost, element("small", one_line(late.sentence)))


def _change(row: Row) -> tuple[str | Markup, ...]:
    change, told = row.change, _told(row.decided)
    if change is None:
        return (element("small", told),) if told else (NONE,)
    words = f"{one_line(change.reason)} ({one_line(change.who)}, {one_line(change.date)})"
    parts = [element("b", signed(Fraction(change.delta))), element("small", words)]
    return (*parts, element("small", told)) if told else tuple(parts)


def _told(decided: Decided | None) -> str:
    """Return in short what graders have said."""
    if decided is None:
        return ""
    found: list[str] = []
    for count, what in (
        (len(decided.items), "rubric item"),
        (len(decided.comments), "comment"),
        (len(decided.conflicts), "conflict"),
        (len(decided.lapsed), "decision about another program"),
    ):
        if count:
            plural = what.replace("decision", "decisions") if " about " in what else f"{what}s"
            found.append(f"{count} {what if count == 1 else plural}")
    if decided.due:
        found.append(f"due {due_words(decided.due)}")
    if decided.excused:
        found.append(f"excused: {one_line(decided.excused)}")
    return ", ".join(found)
