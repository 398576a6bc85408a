"""A class on one page: who has which mark and why, how marks spread, what goes wrong most."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.check.verdict import Answer
from vrts.report.assessment import Assessment
from vrts.report.audience import needs_review
from vrts.report.document import document
from vrts.report.first_screen import FirstScreen, first_screen
from vrts.report.html import Markup, element, joined, prose, raw
from vrts.report.plain import one_line, yes_no
from vrts.report.quantities import lost, mark, points
from vrts.report.review import review_of
from vrts.web.assets import asset

KINDS = {
    "target": "Objects not where they should be",
    "via": "Via points missed",
    "contact": "Contacts",
    "drop": "Objects dropped",
    "demand": "Demands of the task not kept",
    "time": "Time",
    "program": "Programs that do not compile or run",
}
WORST = 8  # rows of the table of what goes wrong


class Row(NamedTuple):
    """One submission."""

    assessment: Assessment
    screen: FirstScreen


def page_name(a: Assessment) -> str:
    """Return the address of an assessment's page beside the overview."""
    return f"{a.identifier}.html"


def overview(
    assessments: Sequence[Assessment],
    title: str,
    link: Callable[[Assessment], str | None] = page_name,
) -> str:
    """Return the page of a class.

    Args:
        assessments: In the order of the table.
        title: Of the class or task.
        link: The address of an assessment's own page, relative to this one; None for no link.
    """
    rows = [Row(a, first_screen(a)) for a in assessments]
    body = [
        _summary(rows, title),
        _table(rows, link),
        _worst(rows),
        element("footer", element("p", "Written by vrts")),
    ]
    script = raw("script", asset("report/overview.js"), type="module")
    return document(one_line(title), "report/overview.css", body, [script])


def _summary(rows: Sequence[Row], title: str) -> Markup:
    marks = sorted(row.screen.mark for row in rows if row.screen.mark is not None)
    ready = sum(row.screen.ready for row in rows)
    facts = [
        f"{len(rows)} submission{'' if len(rows) == 1 else 's'}",
        f"{ready} ready for the real robot",
    ]
    if marks:
        mean = sum(marks, Fraction(0)) / len(marks)
        facts += [f"mean mark {points(mean)}", f"median {points(_median(marks))}"]
    return element(
        "header",
        element("div", element("h1", one_line(title)), element("p", " · ".join(facts))),
        _histogram(marks) if marks else None,
        class_="first-screen",
    )


def _median(marks: Sequence[Fraction]) -> Fraction:
    half = len(marks) // 2
    return marks[half] if len(marks) % 2 else (marks[half - 1] + marks[half]) / 2


def _histogram(marks: Sequence[Fraction]) -> Markup:
    """Return how many marks fall in 0 to 1, 1 to 2, .. 9 to 10; 10 counts in the last."""
    counts = [0] * 10
    for value in marks:
        counts[min(9, int(value))] += 1
    most = max(counts)
    bars = [
        element(
            "div",
            element("b", str(count) if count else ""),
            element("i", style=f"height:{100 * count / most:.0f}%"),
            element("span", f"{low}–{low + 1}"),
            title=f"{count} with a mark from {low} to {low + 1}",
        )
        for low, count in enumerate(counts)
    ]
    label = "Marks: " + ", ".join(f"{low} to {low + 1}: {n}" for low, n in enumerate(counts) if n)
    caption = element("figcaption", "Number of submissions by mark")
    bar_list = element("div", *bars, class_="bars", role="img", aria_label=label)
    return element("figure", bar_list, caption, class_="histogram")


def _table(rows: Sequence[Row], link: Callable[[Assessment], str | None]) -> Markup:
    heads = ("Submission", "Mark", "Ready", "Status", "Costliest cause")
    head = element(
        "tr",
        *(element("th", element("button", h, type="button"), scope="col") for h in heads),
    )
    body = [_row(row, link(row.assessment)) for row in rows]
    table = element("table", element("thead", head), element("tbody", *body), id="submissions")
    return element("section", element("h2", "Submissions"), element("div", table, class_="wide"))


def _row(row: Row, address: str | None) -> Markup:
    a, screen = row
    name = one_line(a.title)
    ready = yes_no(screen.ready)
    number = screen.mark
    return element(
        "tr",
        element("td", element("a", name, href=address) if address else name, data_sort=name),
        element(
            "td",
            mark(number) if number is not None else "–",
            class_="number",
            data_sort=float(number) if number is not None else -1,
        ),
        element("td", ready, class_=f"ready-{ready}", data_sort=ready),
        element(
            "td",
            screen.status,
            element("span", "review", class_="tag review") if needs_review(a) else None,
            data_sort=screen.status,
        ),
        element("td", prose(screen.cause), _review(a), data_sort=screen.cause),
    )


def _review(a: Assessment) -> Markup | None:
    """Return between which marks a person has to decide, and why."""
    review = review_of(a)
    if review is None:
        return None
    between = f" {review.range}" if review.range else ""
    return element("p", element("strong", f"review{between}"), f": {'; '.join(review.reasons)}")


def _worst(rows: Sequence[Row]) -> Markup | None:
    """Return the kinds of loss by points lost, and the checks most often violated."""
    losses = [(row, loss) for row in rows for loss in row.screen.losses if loss.kind != "rounding"]
    found: list[tuple[Fraction, int, str]] = []
    for kind in dict.fromkeys(loss.kind for _, loss in losses):
        total = sum((loss.points for _, loss in losses if loss.kind == kind), Fraction(0))
        who = {id(row.assessment) for row, loss in losses if loss.kind == kind and loss.points > 0}
        found.append((total, len(who), KINDS.get(kind, kind)))
    found.sort(key=lambda entry: (-entry[0], entry[2]))
    parts = [
        element("h2", "What goes wrong most"),
        _counts(
            ("Cause", "Submissions", "Points lost in all"),
            [(text, str(n), lost(total)) for total, n, text in found if n],
        ),
        _counts(("Check not met", "Submissions"), _violated(rows)),
    ]
    return element("section", joined(parts)) if found or _violated(rows) else None


def _violated(rows: Sequence[Row]) -> list[tuple[str, str]]:
    counts: dict[str, int] = {}
    for row in rows:
        judgement = row.assessment.judgement
        checks = (
            {v.check for v in judgement.verdicts if v.answer is Answer.VIOLATED}
            if judgement
            else set[str]()
        )
        for check in sorted(checks):
            counts[check] = counts.get(check, 0) + 1
    ordered = sorted(counts.items(), key=lambda entry: (-entry[1], entry[0]))
    return [(one_line(check), str(count)) for check, count in ordered[:WORST]]


def _counts(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> Markup | None:
    if not rows:
        return None
    head = element("tr", *(element("th", text, scope="col") for text in heads))
    body = [
        element("tr", element("td", row[0]), *(element("td", n, class_="number") for n in row[1:]))
        for row in rows
    ]
    return element("table", element("thead", head), element("tbody", *body), class_="counts")
