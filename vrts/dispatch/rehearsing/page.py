"""A rehearsal as one HTML page, and as lines for a terminal."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from vrts.base.units import DEG, MM
from vrts.dispatch.rehearsing.measured import Course, Stretch, courses
from vrts.dispatch.rehearsing.rehearse import Rehearsal
from vrts.report.figures.figures import series_figure
from vrts.report.page.document import document
from vrts.report.page.html import Child, Markup, element
from vrts.report.plain import one_line

Array = npt.NDArray[np.float64]

TIP, JOINTS = "mm", "deg"
LEAST = 0.02  # a frame shows so much: what is smaller is nothing to look at
MOST_FOLDS = 60  # motions that are drawn one by one
STYLE = "report/validation.css"
NAMES = (
    *("motions", "step", "kind", "path [mm]", "equal time [mm]", "end [mm]"),
    *("joints [deg]", "duration [ms]", ""),
)
METHOD = (
    "Each row goes from one stop of the arm to the next. The path is LinuxCNC's commanded motion,"
    " each millisecond, beside the path that vrts verified; equal time counts from the middle of"
    " the stretch, and durations from a hundredth of the way to the last hundredth. Pauses between"
    " stretches are LinuxCNC's own and are not compared."
)


def summary(found: Rehearsal) -> tuple[str, ...]:
    """Return what was measured, in lines: the worst of each kind."""
    lines: list[str] = []
    for rounded, kind in ((False, "from stop to stop"), (True, "rounded or turning")):
        chosen = [s for s in found.stretches if s.rounded is rounded and not s.missing]
        if chosen:
            lines.append(
                f"{len(chosen)} {kind}: path {max(s.path_mm for s in chosen):.4f} mm, equal time"
                f" {max(s.equal_mm for s in chosen):.4f} mm, end"
                f" {max(s.end_mm for s in chosen):.4f} mm, duration within"
                f" {1e3 * max(abs(s.longer_s) for s in chosen):.2f} ms"
            )
    return tuple(lines)


def rehearsal_page(found: Rehearsal, name: str) -> str:
    """Return the page.

    Args:
        found: What was measured.
        name: Of the folder, as shown.
    """
    verdict = "LinuxCNC moves as vrts verified" if found.holds else "LinuxCNC moves otherwise"
    told = [d.headline for d in found.diagnostics]
    body: list[Child] = [
        element(
            "header",
            element(
                "div",
                element("h1", f"{one_line(name)} beside LinuxCNC"),
                element("p", element("b", verdict)),
                *(element("p", line) for line in summary(found)),
                *(element("p", line) for line in told),
            ),
            class_="first-screen",
        ),
        element("section", element("h2", "Motions"), _table(found.stretches)),
        *_figures(found),
        element("section", element("h2", "How it was compared"), element("p", METHOD)),
        element("footer", element("p", "Written by vrts")),
    ]
    return document(f"{one_line(name)}: rehearsal", STYLE, body, ())


def _figures(found: Rehearsal) -> Iterator[Markup]:
    """Yield the errors over time: of the whole rehearsal, then motion by motion."""
    seen = courses(found.run, found.samples, found.stretches)
    if not seen:
        return
    yield element(
        "section",
        element("h2", "Errors over time"),
        _figure(seen, TIP, "The tip of the tool, from where it is to be then, and from its path"),
        _figure(seen, JOINTS, "Joints at equal times: LinuxCNC minus the run"),
    )
    folds = [
        element(
            "details",
            element("summary", _title(one.stretch)),
            _figure((one,), TIP, "The tip of the tool"),
            _figure((one,), JOINTS, "Joints at equal times"),
        )
        for one in seen[:MOST_FOLDS]
    ]
    more = len(seen) - len(folds)
    told = element("p", f"{more} more motions are not drawn one by one") if more else None
    yield element("section", element("h2", "Motion by motion"), *folds, told)


def _title(s: Stretch) -> str:
    number, line, kind = _named(s)
    many = "motion" if s.first == s.last else "motions"
    return f"{many} {number}, {line}, {kind}" + ("" if s.holds else ": too far")


def _figure(seen: Sequence[Course], which: str, caption: str) -> Markup:
    times = np.concatenate([one.times for one in seen])
    curves: list[tuple[str, Array]]
    if which == TIP:
        curves = [
            ("equal time", np.concatenate([one.equal for one in seen]) / MM),
            ("path", np.concatenate([one.path for one in seen]) / MM),
        ]
    else:
        joints = np.concatenate([one.joints for one in seen]) / DEG
        curves = [(f"JT{k + 1}", joints[:, k]) for k in range(joints.shape[1])]
    marks = [(float(one.times[0]), str(one.stretch.first)) for one in seen]
    drawn = series_figure(times, curves, which, LEAST, marks if len(seen) > 1 else ())
    return element("figure", drawn, element("figcaption", caption))


def _table(stretches: Iterable[Stretch]) -> Markup:
    head = element("tr", *(element("th", name) for name in NAMES))
    rows = (element("tr", *(element("td", cell) for cell in _cells(s))) for s in stretches)
    return element("div", element("table", head, *rows, class_="rehearsed"), class_="scroll")


def _named(s: Stretch) -> tuple[str, str, str]:
    number = f"{s.first}" if s.first == s.last else f"{s.first} to {s.last}"
    return number, s.line, "rounded or turning" if s.rounded else "stop to stop"


def _cells(s: Stretch) -> tuple[str, ...]:
    number, _, kind = _named(s)
    if s.missing:
        return (number, s.line, kind, *("",) * 5, "missing")
    return (
        *(number, s.line, kind),
        *(f"{value:.4f}" for value in (s.path_mm, s.equal_mm, s.end_mm, s.joints_deg)),
        f"{1e3 * s.longer_s:+.2f}",
        "" if s.holds else "too far",
    )
