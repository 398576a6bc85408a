"""Figures of a comparison as SVG: the path with its errors, and errors over time."""

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from vrts.report.page.html import Markup, element

Array = npt.NDArray[np.float64]

WIDTH, MARGIN = 760.0, 60.0
MOST_POINTS = 900  # of a curve: pairs of least and greatest
ARROWS = 120  # error lines of a path
ERROR_SHARE = 0.09  # of the figure: how long a large error is drawn
TOP, LEGEND = 30.0, 20.0  # of a frame, and the line that names its curves
LETTER = 13.0  # of a name on a narrow screen, where letters are large
NAMES_APART = 34.0
NICE = (1.0, 2.0, 5.0, 10.0)


def path_figure(virtual: Array, real: Array) -> Markup:
    """Return a path from above, or from the side it is widest on, with its errors enlarged.

    Args:
        virtual: Where the tool should be, shape (n, 3) [mm].
        real: Where it was.
    """
    spans = np.ptp(virtual, axis=0)
    across, up = sorted(sorted(range(3), key=lambda k: (-spans[k] > -1.0, k))[:2])
    if float(spans[[across, up]].min()) < 1.0 and float(spans.max()) > 1.0:
        across, up = sorted(np.argsort(spans)[-2:].tolist())
    flat, error = virtual[:, [across, up]], (real - virtual)[:, [across, up]]
    low, high = flat.min(axis=0), flat.max(axis=0)
    extent = float(max((high - low).max(), 1e-6))
    large = float(np.quantile(np.linalg.norm(error, axis=1), 0.95))
    factor = _nice_below(ERROR_SHARE * extent / large) if large > 0.0 else 1.0
    room = ERROR_SHARE * extent * 1.6
    low, high = low - room, high + room
    scale = (WIDTH - MARGIN) / float(high[0] - low[0])
    height = scale * float(high[1] - low[1]) + MARGIN
    if height > WIDTH:
        scale *= (WIDTH - MARGIN) / (height - MARGIN)
        height = scale * float(high[1] - low[1]) + MARGIN

    def placed(points: Array) -> Array:
        x = MARGIN + scale * (points[:, 0] - low[0])
        return np.column_stack((x, scale * (high[1] - points[:, 1])))

    far = placed(flat + factor * error)
    near = placed(flat)
    step = max(len(flat) // ARROWS, 1)
    lines = [
        element(
            "line",
            x1=_number(near[k, 0]),
            y1=_number(near[k, 1]),
            x2=_number(far[k, 0]),
            y2=_number(far[k, 1]),
            class_="error",
        )
        for k in range(0, len(flat), step)
    ]
    axes = ("X", "Y", "Z")
    bar = _nice_below(0.3 * extent)
    bottom = height - MARGIN / 2
    legend = [
        _text(MARGIN, 16, "simulated", "s-virtual"),
        _text(MARGIN + 90, 16, f"real, errors {factor:g} times as large", "s-real"),
        element(
            "line",
            x1=MARGIN,
            y1=_number(bottom),
            x2=_number(MARGIN + scale * bar),
            y2=_number(bottom),
            class_="bar",
        ),
        _text(MARGIN, bottom + 16, f"{bar:g} mm"),
        _text(WIDTH - 150, bottom + 16, f"{axes[across]} to the right, {axes[up]} up"),
    ]
    return _svg(
        height,
        f"Path of the tool, {axes[across]} and {axes[up]}; errors {factor:g} times as large",
        _polyline(near, "virtual"),
        *lines,
        _polyline(far, "real"),
        *legend,
    )


def series_figure(
    times: Array,
    curves: Sequence[tuple[str, Array]],
    unit: str,
    limit: float = 0.0,
    marks: Sequence[tuple[float, str]] = (),
) -> Markup:
    """Return curves over time in one frame.

    Args:
        times: Shape (n,) [s].
        curves: Names and values, shape (n,).
        unit: Of the values.
        limit: The frame reaches at least so far, up and down; 0: as the values do.
        marks: Times at which something begins, and what; between them curves are not joined.
    """
    height = 218.0
    known = [values[np.isfinite(values)] for _, values in curves]
    greatest = max((float(np.abs(v).max()) for v in known if len(v)), default=0.0)
    lowest = -1.0 if any((v < 0.0).any() for v in known) else 0.0  # sizes alone begin at nothing
    top = max(greatest, limit, 1e-9)
    step = _nice_above(top / (2.0 if lowest else 4.0))
    top = max(math.ceil(top / step - 1e-9), 1) * step
    start, end = float(times[0]), float(times[-1])
    wide, high = WIDTH - MARGIN - 12.0, height - TOP - 24.0

    def placed(t: Array, values: Array) -> Array:
        x = MARGIN + wide * (t - start) / max(end - start, 1e-9)
        return np.column_stack((x, TOP + high * (1.0 - values / top) / (1.0 - lowest)))

    parts: list[Markup] = []
    for k in range(round(lowest * top / step), round(top / step) + 1):
        y = TOP + high * (1.0 - k * step / top) / (1.0 - lowest)
        kind = "zero" if k == 0 else "grid"
        parts.append(
            element("line", x1=MARGIN, y1=_number(y), x2=WIDTH - 12.0, y2=_number(y), class_=kind)
        )
        parts.append(_text(MARGIN - 6, y + 4, f"{k * step:g}", "tick"))
    nearest = -math.inf  # where the last name stands
    for time_s, name in marks:
        x = MARGIN + wide * (time_s - start) / max(end - start, 1e-9)
        ends = {"y1": _number(TOP), "y2": _number(TOP + high)}
        parts.append(element("line", x1=_number(x), x2=_number(x), class_="grid", **ends))
        if x - nearest > NAMES_APART:
            parts.append(_text(x + 3.0, TOP + 18.0, name))
            nearest = x
    every = _nice_above(max(end - start, 1e-9) / 8.0)
    for k in range(math.ceil(start / every), math.floor(end / every) + 1):
        x = MARGIN + wide * (k * every - start) / max(end - start, 1e-9)
        parts.append(_text(x, height - 4, f"{k * every:g} s", "time"))
    at = MARGIN
    cuts = np.searchsorted(times, [time_s for time_s, _ in marks])
    for k, (name, values) in enumerate(curves):
        for piece in np.split(np.arange(len(times)), cuts):
            if len(piece):
                line = placed(*_thinned(times[piece], values[piece]))
                parts.append(_polyline(line, f"s{k}"))
        parts.append(_text(at, LEGEND, name, f"t{k}"))
        at += 18.0 + LETTER * len(name)
    parts.append(_text(WIDTH - 12.0, LEGEND, unit, "unit"))
    names = ", ".join(name for name, _ in curves)
    return _svg(height, f"{names} over time, in {unit}", *parts)


def _thinned(times: Array, values: Array) -> tuple[Array, Array]:
    """Return a curve with fewer points that keeps its extremes."""
    known = np.isfinite(values)
    times, values = times[known], values[known]
    width = len(times) // (MOST_POINTS // 2)
    if width < 2:
        return times, values
    count = len(times) // width
    block = values[: count * width].reshape(count, width)
    offsets = np.arange(count) * width
    ends = np.column_stack((offsets + block.argmin(axis=1), offsets + block.argmax(axis=1)))
    kept = np.unique(np.concatenate((ends.ravel(), np.arange(count * width, len(times)))))
    return times[kept], values[kept]


def _svg(height: float, label: str, *parts: Markup) -> Markup:
    return element(
        "svg",
        *parts,
        viewBox=f"0 0 {WIDTH:g} {_number(height)}",
        role="img",
        aria_label=label,
        class_="figure",
    )


def _polyline(points: Array, kind: str) -> Markup:
    text = " ".join(f"{x:.1f},{y:.1f}" for x, y in points.tolist())
    return element("polyline", points=text, class_=kind)


def _text(x: float, y: float, words: str, kind: str | None = None) -> Markup:
    return element("text", words, x=_number(x), y=_number(y), class_=kind)


def _number(value: float) -> str:
    return f"{float(value):.1f}"


def _nice_below(value: float) -> float:
    """Return the greatest of 1, 2, 5, 10, … that is not above a positive number."""
    power = 10.0 ** math.floor(math.log10(value))
    return max(nice * power for nice in NICE if nice * power <= value * (1.0 + 1e-12))


def _nice_above(value: float) -> float:
    """Return the least of 1, 2, 5, 10, … that is not below a positive number."""
    power = 10.0 ** math.floor(math.log10(value))
    return min(nice * power for nice in NICE if nice * power >= value * (1.0 - 1e-12))
