"""A rehearsal as one HTML page, and as lines for a terminal."""

from collections.abc import Iterable

from vrts.dispatch.rehearsing.measured import Stretch
from vrts.dispatch.rehearsing.rehearse import Rehearsal
from vrts.report.page.document import document
from vrts.report.page.html import Child, Markup, element
from vrts.report.plain import one_line

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
        element("section", element("h2", "How it was compared"), element("p", METHOD)),
        element("footer", element("p", "Written by vrts")),
    ]
    return document(f"{one_line(name)}: rehearsal", STYLE, body, ())


def _table(stretches: Iterable[Stretch]) -> Markup:
    head = element("tr", *(element("th", name) for name in NAMES))
    rows = (element("tr", *(element("td", cell) for cell in _cells(s))) for s in stretches)
    return element("table", head, *rows)


def _cells(s: Stretch) -> tuple[str, ...]:
    number = f"{s.first}" if s.first == s.last else f"{s.first} to {s.last}"
    kind = "rounded or turning" if s.rounded else "stop to stop"
    if s.missing:
        return (number, s.line, kind, *("",) * 5, "missing")
    return (
        *(number, s.line, kind),
        *(f"{value:.4f}" for value in (s.path_mm, s.equal_mm, s.end_mm, s.joints_deg)),
        f"{1e3 * s.longer_s:+.2f}",
        "" if s.holds else "too far",
    )
