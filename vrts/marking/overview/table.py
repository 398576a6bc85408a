"""Every submission in one table, to be sorted, searched and filtered."""

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

from vrts.marking.overview.links import sent_report, staff_report
from vrts.marking.overview.words import KINDS, NONE, has_report, name_of, tenth, to_review, who
from vrts.marking.row import Row
from vrts.report.page.html import Child, Markup, element, prose
from vrts.report.plain import one_line, yes_no


class Column(NamedTuple):
    """A column; minor ones are left out on phones."""

    title: str
    minor: bool = False
    number: bool = False


COLUMNS = (
    Column("Submission"),
    Column("Final", number=True),
    Column("Computed", minor=True, number=True),
    Column("Status"),
    Column("Ready", minor=True),
    Column("Time", minor=True, number=True),
    Column("Contacts", minor=True, number=True),
    Column("Costliest cause"),
    Column("Sent", minor=True),
)
FLAGS = {"review": "to be reviewed", "late": "late", "changed": "changed", "nomark": "no mark"}


def table(rows: Sequence[Row], *, pages: bool) -> Markup:
    """Return the section with the table and what steers it."""
    heads = [
        element(
            "th",
            element("button", column.title, type="button"),
            scope="col",
            class_=_classes(column),
        )
        for column in COLUMNS
    ]
    body = [_row(row, pages=pages) for row in rows]
    return element(
        "section",
        element("h2", "All submissions", id="all-head"),
        _controls(rows),
        element(
            "div",
            element(
                "table",
                element("thead", element("tr", *heads)),
                element("tbody", *body),
                id="submissions",
            ),
            class_="wide",
            role="region",
            tabindex="0",
            aria_labelledby="all-head",
        ),
        element("p", "Nothing matches the search.", id="none", hidden=True),
        id="all",
    )


def flags(row: Row) -> tuple[str, ...]:
    """Return by which filters a row is found."""
    held = {
        "review": to_review(row),
        "late": row.late is not None and not row.late.untimed,
        "changed": row.change is not None,
        "nomark": row.final is None,
    }
    return tuple(name for name, holds in held.items() if holds)


def _controls(rows: Sequence[Row]) -> Markup:
    counts = Counter(row.result.kind for row in rows)
    held = Counter(flag for row in rows for flag in flags(row))
    options = [element("option", "any status", value="")]
    options += [
        element("option", f"{text} ({counts[kind]})", value=kind.name.lower())
        for kind, text in KINDS.items()
        if counts[kind]
    ]
    boxes = [
        element(
            "label",
            element("input", type="checkbox", value=name),
            f" {text} ",
            element("small", str(held[name])),
        )
        for name, text in FLAGS.items()
        if held[name]
    ]
    search = element(
        "label",
        element("span", "Search"),
        element("input", type="search", id="search", placeholder="name, cause, …", size=24),
    )
    status = element("label", element("span", "Status"), element("select", *options, id="kind"))
    count = f"{len(rows)} of {len(rows)}"
    return element(
        "div",
        search,
        status,
        *boxes,
        element("output", count, id="count", aria_live="polite"),
        class_="filters",
        id="filters",
        role="search",
    )


def _row(row: Row, *, pages: bool) -> Markup:
    result = row.result
    linked = pages and has_report(row)
    link = staff_report(row.id) if linked else None
    name = name_of(row)
    sent = (
        element("a", "page", href=sent_report(row.id), aria_label=f"Page sent to {name}")
        if linked
        else NONE
    )
    found_by = (name, row.id, row.student.login, row.student.email, row.handed_in.file)
    metrics = result.metrics
    kind = KINDS[result.kind]
    tags = [element("span", FLAGS[flag], class_=f"tag {flag}") for flag in flags(row)]
    ready = yes_no(result.ready)
    shown_ready = ready if has_report(row) else NONE
    cells: list[tuple[tuple[Child, ...], str | float]] = [
        ((who(row, link),), name),
        ((tenth(row.final),), _key(row.final)),
        ((tenth(result.mark),), _key(result.mark)),
        ((element("span", kind), *tags), kind),
        ((element("span", shown_ready, class_=f"ready-{ready}"),), shown_ready),
        ((_seconds(metrics.duration_s),), _key(metrics.duration_s)),
        ((NONE if metrics.contacts is None else str(metrics.contacts),), _key(metrics.contacts)),
        ((prose(one_line(result.cause)),), one_line(result.cause)),
        ((sent,), ""),
    ]
    return element(
        "tr",
        *(
            element("td", *children, class_=_classes(column), data_sort=key)
            for column, (children, key) in zip(COLUMNS, cells, strict=True)
        ),
        data_kind=result.kind.name.lower(),
        data_flags=" ".join(flags(row)) or None,
        data_found=" ".join(one_line(text) for text in found_by if text).lower(),
    )


def _classes(column: Column) -> str | None:
    found = [("minor", column.minor), ("number", column.number)]
    return " ".join(name for name, holds in found if holds) or None


def _key(value: float | None) -> float:
    return -1 if value is None else value


def _seconds(value: float | None) -> str:
    return NONE if value is None else f"{value:.1f} s"
