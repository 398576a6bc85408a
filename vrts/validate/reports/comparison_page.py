"""A comparison as one HTML page: what was found, figures, tables, and what they do not say."""

from collections.abc import Sequence

import numpy as np

from vrts.base.diagnostic import Diagnostic
from vrts.base.units import DEG, MM
from vrts.report.figures.figures import path_figure, series_figure
from vrts.report.page.document import document
from vrts.report.page.html import Child, Markup, element, prose
from vrts.report.plain import capital, one_line
from vrts.validate.comparison import Comparison
from vrts.validate.errors import Measures, lengths, measures
from vrts.validate.reports.comparison_text import (
    SYNTHETIC,
    joint_rows,
    offset_lines,
    path_rows,
)

STYLE = "report/validation.css"

METHOD = """
The errors are the real robot minus the simulated one, at every instant of the log at which the \
arm was under way. Nothing is made up between the rows of a log.
*Before* takes the log's clock as it is, or, where it shows another time altogether, as it comes \
closest to within some 20 ms. *After* takes the fitted offsets into account.
A mean square is in mm²; its root (RMS) is in mm. Published tables do not always say which.
Positions are those of the tool's tip in the frame of the robot's base.
"""


def comparison_page(c: Comparison, name: str) -> str:
    """Return the page.

    Args:
        c: The comparison.
        name: Of the program, as shown.
    """
    body: list[Child] = [
        _head(c, name),
        _path(c),
        _joints(c) if c.after.joints is not None else None,
        _timing(c),
        _findings(c.findings) if c.findings else None,
        _method(c),
        element("footer", element("p", "Written by vrts")),
    ]
    return document(f"{one_line(name)}: validation", STYLE, body, ())


def _head(c: Comparison, name: str) -> Markup:
    after = dict(path_rows(c, c.after))
    other = "a made-up robot" if c.log.synthetic else "a real robot"
    where = f"log {one_line(c.log.name)} · {len(c.after.times):,} samples · {c.run.scene.title}"
    tiles = [
        ("mm², mean square X", f"{after['X'].mean_square:.2f}"),
        ("mm², mean square Y", f"{after['Y'].mean_square:.2f}"),
        ("mm², mean square Z", f"{after['Z'].mean_square:.2f}"),
        ("mm, farthest off", f"{measures(lengths(c.after) / MM).largest:.2f}"),
    ]
    if c.after.joints is not None:
        known = c.after.joints[np.isfinite(c.after.joints).all(axis=1)] / DEG
        tiles.append(("deg, joints (RMS)", f"{float(np.sqrt((known**2).mean())):.3f}"))
    return element(
        "header",
        element(
            "div",
            element("h1", f"{one_line(name)} beside {other}"),
            element("p", where, class_="where"),
            element("p", element("b", capital(SYNTHETIC)), class_="synthetic")
            if c.log.synthetic
            else None,
            element(
                "dl",
                *(element("div", element("dt", t), element("dd", v)) for t, v in tiles),
                class_="tiles",
            ),
        ),
        class_="first-screen",
    )


def _path(c: Comparison) -> Markup:
    source = "worked out from logged joints" if c.after.from_joints else "as logged"
    curves = [(axis, c.after.path[:, k] / MM) for k, axis in enumerate("XYZ")]
    return element(
        "section",
        element("h2", "The path"),
        element("p", f"Positions of the tool: {source}.", class_="where"),
        _figure(
            path_figure(c.after.virtual / MM, c.after.real / MM),
            "The path and its errors, after the fit",
        ),
        _figure(
            series_figure(c.after.times, curves, "mm"),
            "Errors of the tool over time",
        ),
        _table(
            "Error of the tool, before and after the fit",
            ("mean square [mm²]", "RMS [mm]", "maximum [mm]"),
            [
                (label, (_cells(a, 3), _cells(b, 3)))
                for (label, a), (_, b) in zip(
                    path_rows(c, c.before), path_rows(c, c.after), strict=True
                )
            ],
        ),
        element("h3", "Offsets of the real robot"),
        element("pre", "\n".join(line.strip() for line in offset_lines(c))),
        id="path",
    )


def _joints(c: Comparison) -> Markup:
    assert c.after.joints is not None
    errors = c.after.joints / DEG
    limit = float(np.nanmax(np.abs(errors)))
    figures = [
        _figure(series_figure(c.after.times, [(f"JT{k + 1}", errors[:, k])], "deg", limit), None)
        for k in range(6)
    ]
    rows = [
        (label, (_cells(a, 4), _cells(b, 4)))
        for (label, a), (_, b) in zip(joint_rows(c.before), joint_rows(c.after), strict=True)
    ]
    return element(
        "section",
        element("h2", "The joints"),
        element("div", *figures, class_="six"),
        _table(
            "Error of the joints, before and after the fit",
            ("mean square [deg²]", "RMS [deg]", "maximum [deg]"),
            rows,
        ),
        id="joints",
    )


def _timing(c: Comparison) -> Markup:
    rows = [
        element(
            "tr",
            element("td", str(t.line), class_="number"),
            element("td", element("code", one_line(t.words))),
            element("td", f"{t.start_s:.2f} to {t.end_s:.2f} s", class_="number"),
            *(
                element(
                    "td", "·" if v is None else f"{round(1e3 * v, 1) + 0.0:+.1f}", class_="number"
                )
                for v in t.late
            ),
        )
        for t in c.timings
    ]
    head = ("Line", "Instruction", "In the run", "at 10 %", "at 50 %", "at 90 %")
    return element(
        "section",
        element("h2", "When"),
        element(
            "p",
            "By how many milliseconds the real arm was later than the simulated one, after the fit,"
            " at three times of each motion. A dot: the arm hardly moves there, or was not found.",
        ),
        _scrolled(
            element(
                "table",
                element("thead", element("tr", *(element("th", t, scope="col") for t in head))),
                element("tbody", *rows),
                class_="timing",
            ),
            "Lateness of every motion",
        ),
        id="timing",
    )


def _findings(findings: Sequence[Diagnostic]) -> Markup:
    items = [
        element(
            "li",
            element("b", f"{d.severity.value} {d.rule.code}: "),
            prose(one_line(d.headline)),
            *(element("div", prose(one_line(note)), class_="where") for note in d.notes),
        )
        for d in findings
    ]
    return element("section", element("h2", "To be known"), element("ul", *items), id="findings")


def _method(c: Comparison) -> Markup:
    items = [element("li", _emphasised(text)) for text in METHOD.strip().split("\n")]
    return element(
        "section",
        element("h2", "How this was worked out"),
        element("ul", *items, element("li", f"The log's SHA-256 is {c.log.sha256}.")),
        id="method",
        class_="box",
    )


def _emphasised(text: str) -> Markup:
    parts = text.split("*")
    return element("span", *(element("em", p) if k % 2 else p for k, p in enumerate(parts)))


def _figure(drawing: Markup, caption: str | None) -> Markup:
    return element("figure", drawing, element("figcaption", caption) if caption else None)


def _cells(m: Measures, decimals: int) -> tuple[str, str, str]:
    return (
        f"{m.mean_square:.{decimals}f}" if decimals < 4 else f"{m.mean_square:.6f}",
        f"{m.rms:.{decimals}f}",
        f"{m.largest:.{decimals}f}",
    )


def _table(
    caption: str,
    columns: tuple[str, str, str],
    rows: Sequence[tuple[str, tuple[tuple[str, ...], tuple[str, ...]]]],
) -> Markup:
    head = [element("th", "of", scope="col", rowspan=2)]
    head += [element("th", column, scope="colgroup", colspan=2) for column in columns]
    words = ("before", "after") * len(columns)
    below = [element("th", word, scope="col", class_="number") for word in words]
    body = [
        element(
            "tr",
            element("th", label, scope="row"),
            *(
                element("td", value, class_="number")
                for pair in zip(before, after, strict=True)
                for value in pair
            ),
        )
        for label, (before, after) in rows
    ]
    table = element(
        "table",
        element("caption", caption),
        element("thead", element("tr", *head), element("tr", *below)),
        element("tbody", *body),
        class_="errors",
    )
    return _scrolled(table, caption)


def _scrolled(table: Markup, name: str) -> Markup:
    """Return a table that can be moved on narrow screens, also by keys."""
    return element("div", table, class_="scroll", tabindex=0, role="region", aria_label=name)
