"""Who made the same mistake, and what would mend it: where marking was asked to look for that."""

from collections.abc import Sequence

from vrts.marking.overview.links import staff_report
from vrts.marking.overview.words import has_report, tenth, who
from vrts.marking.row import Row
from vrts.report.page.html import Markup, element, prose
from vrts.report.plain import one_line


def causes(rows: Sequence[Row], *, pages: bool) -> Markup | None:
    """Return submissions by what is wrong with them, the commonest first; None: nobody looked."""
    groups = by_cause(rows)
    if not groups:
        return None
    return element(
        "section",
        element("h2", "Changes that would earn the full mark, or more points"),
        *(_group(cause, group, pages=pages) for cause, group in groups.items()),
        id="causes",
    )


def by_cause(rows: Sequence[Row]) -> dict[str, list[Row]]:
    """Return the submissions that a change would mend, by cause, the commonest first."""
    found: dict[str, list[Row]] = {}
    for row in rows:
        if row.result.mending is not None:
            found.setdefault(one_line(row.result.mending.cause), []).append(row)
    for group in found.values():
        group.sort(key=lambda row: (-_would_earn(row), -(row.final or 0.0)))
    return dict(sorted(found.items(), key=lambda item: (-len(item[1]), item[0])))


def _would_earn(row: Row) -> float:
    """Return the mark that the change would earn; what earlier results do not tell is 0."""
    mending = row.result.mending
    return 0.0 if mending is None else mending.mark or 0.0


def _group(cause: str, rows: Sequence[Row], *, pages: bool) -> Markup:
    items = [_item(row, pages=pages) for row in rows]
    count = element("small", f" ({len(rows)})")
    return element("div", element("h3", prose(cause), count), element("ul", *items))


def _item(row: Row, *, pages: bool) -> Markup:
    assert row.result.mending is not None
    link = staff_report(row.id) if pages and has_report(row) else None
    said = one_line(row.result.mending.sentence)
    return element("li", who(row, link), f" {tenth(row.final)}: ", prose(said))
