"""The first screen of the overview: how many, how good, and what became of them."""

from collections import Counter
from collections.abc import Sequence

from vrts.check.rules.scheme import TOTAL
from vrts.marking.overview.figures import BINS, Spread, spread
from vrts.marking.overview.words import KINDS, to_review
from vrts.marking.result import PROVEN
from vrts.marking.row import Row
from vrts.report.page.html import Markup, element
from vrts.report.plain import one_line
from vrts.report.quantities import full, points


def top(rows: Sequence[Row], title: str, where: str) -> Markup:
    """Return the head of the page."""
    found = spread(rows)
    words = element(
        "div",
        element("h1", one_line(title)),
        element("p", one_line(where), class_="where") if where else None,
        _tiles(rows, found),
        _kinds(rows) if rows else None,
    )
    return element("header", words, _histogram(found) if found else None, class_="first-screen")


def _tiles(rows: Sequence[Row], found: Spread | None) -> Markup:
    tiles = [("submission" if len(rows) == 1 else "submissions", str(len(rows)))]
    if found is not None:
        tiles += [("mean mark", points(found.mean)), ("median", points(found.median))]
        tiles += [("full marks", full(found.total))] if found.total != TOTAL else []
    ready = [row.result for row in rows if row.result.ready]
    proven = bool(ready) and all(one.ready_in == PROVEN for one in ready)
    tiles += [
        (f"ready, in {PROVEN if proven else 'the scenario of the task'}", str(len(ready))),
        ("to be reviewed", str(sum(to_review(row) for row in rows))),
    ]
    without = sum(row.final is None for row in rows)
    if without:
        tiles.append(("without a mark", str(without)))
    items = [
        element("div", element("dt", label), element("dd", value), class_=_tile_class(label, value))
        for label, value in tiles
    ]
    return element("dl", *items, class_="tiles")


def _tile_class(label: str, value: str) -> str | None:
    return "attention" if label == "to be reviewed" and value != "0" else None


def _kinds(rows: Sequence[Row]) -> Markup:
    """Return what became of the submissions, as one bar and as buttons that filter the table."""
    counts = Counter(row.result.kind for row in rows)
    present = [(kind, text) for kind, text in KINDS.items() if counts[kind]]
    bar = [
        element("i", class_=f"k-{kind.name.lower()}", style=f"flex-grow:{counts[kind]}")
        for kind, _ in present
    ]
    items = [
        element(
            "li",
            element(
                "button",
                element("i", class_=f"k-{kind.name.lower()}", aria_hidden="true"),
                element("b", str(counts[kind])),
                f" {text}",
                type="button",
                data_kind=kind.name.lower(),
                title=f"Show only these below: {text}",
            ),
        )
        for kind, text in present
    ]
    return element(
        "div",
        element("div", *bar, class_="kind-bar", aria_hidden="true"),
        element("ul", *items, class_="kinds"),
    )


def _histogram(found: Spread) -> Markup:
    most = max(found.counts)
    ends = [full(found.total * k / BINS) for k in range(BINS + 1)]
    bars = [
        element(
            "div",
            element("b", str(count)) if count else None,
            element("i", style=f"--share:{count / most:.3f}") if count else None,
            element("span", f"{ends[low]}–{ends[low + 1]}"),
            title=f"{count} with a mark from {ends[low]} to {ends[low + 1]}",
        )
        for low, count in enumerate(found.counts)
    ]
    told = ", ".join(
        f"{ends[low]} to {ends[low + 1]}: {n}" for low, n in enumerate(found.counts) if n
    )
    chart = element("div", *bars, class_="bars", role="img", aria_label=f"Final marks: {told}")
    caption = element("figcaption", "Number of submissions by final mark")
    return element("figure", chart, caption, class_="histogram")
