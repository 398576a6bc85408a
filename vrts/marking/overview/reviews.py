"""What somebody has to look at before marks go out, the widest range of marks first."""

from collections.abc import Sequence

from vrts.marking.overview.links import staff_report
from vrts.marking.overview.words import has_report, name_of, reasons, tenth, to_review, who
from vrts.marking.row import Row
from vrts.marking.unsafe import Reason
from vrts.report.page.html import Markup, element, prose

FIRST = 12  # shown at once
BETWEEN = (
    "The mark as given is the higher one. The lower one counts every doubt against the program."
)


def reviews(rows: Sequence[Row], *, pages: bool) -> Markup | None:
    """Return the list; None where nothing is open."""
    found = sorted((row for row in rows if to_review(row)), key=_order)
    if not found:
        return None
    items = [_item(row, pages=pages) for row in found]
    rest = items[FIRST:]
    more = element(
        "details",
        element("summary", f"{len(rest)} more"),
        element("ol", *rest, class_="reviews"),
    )
    return element(
        "section",
        element("h2", "Look at these first"),
        element("p", _counts(found), class_="where"),
        element("p", BETWEEN, class_="where") if any(map(_is_range, found)) else None,
        element("ol", *items[:FIRST], class_="reviews"),
        more if rest else None,
        id="review",
        class_="review-box",
    )


def _counts(rows: Sequence[Row]) -> str:
    """Return how many marks are unsafe, and for which reasons."""
    there = [{doubt.reason for doubt in row.unsafe} for row in rows]
    counts = {reason: sum(reason in one for one in there) for reason in Reason}
    told = ", ".join(f"{count} {reason.value}" for reason, count in counts.items() if count)
    return f"{len(rows)} unsafe {'mark' if len(rows) == 1 else 'marks'}: {told}"


def _is_range(row: Row) -> bool:
    """Return whether the right mark may be lower than the one that is given."""
    result = row.result
    return result.mark is not None and result.lowest is not None and result.lowest < result.mark


def _order(row: Row) -> tuple[bool, float, str]:
    """Rows without a mark first, then by how much is at stake."""
    result = row.result
    if result.mark is None:
        return False, 0.0, name_of(row)
    lowest = result.mark if result.lowest is None else result.lowest
    return True, lowest - result.mark, name_of(row)


def _item(row: Row, *, pages: bool) -> Markup:
    result = row.result
    link = staff_report(row.id) if pages and has_report(row) else None
    lowest = result.mark if result.lowest is None else result.lowest
    if result.mark is None or lowest is None:
        marks = element("span", element("b", "no mark"), class_="range-words")
        bar = None
    else:
        text = tenth(result.mark)
        if lowest < result.mark:
            text = f"{tenth(lowest)} to {text}"
        width = max(0.0, result.mark - lowest)
        percent = 100 / result.total
        style = f"left:{percent * lowest:.0f}%;width:{percent * width:.0f}%"
        bar = element("span", element("i", style=style), class_="range", aria_hidden="true")
        marks = element("span", element("b", text), class_="range-words")
    words = element("span", *_lines(reasons(row)), class_="why")
    return element("li", who(row, link), marks, bar or element("span"), words)


def _lines(texts: Sequence[str]) -> list[Markup]:
    return [element("span", prose(text)) for text in texts]
