"""Curves of a run for a notebook: one SVG that is legible on light and on dark ground."""

import numpy as np
import numpy.typing as npt

from vrts.report.figures.figures import series_figure
from vrts.report.page.html import element, raw

Array = npt.NDArray[np.float64]

# Of middle brightness, so that they stand out on white and on black; told apart in order.
COLORS = ("#3a86d8", "#d9722a", "#2f9e6e", "#c2529f", "#8f7a1f", "#7a6ee0")
STYLE = (
    ".vrts-run{max-width:780px;font:13px system-ui,sans-serif}"
    ".vrts-run svg{width:100%;height:auto;display:block;color:inherit}"
    ".vrts-run text{fill:currentColor;font-size:12px}"
    ".vrts-run .tick,.vrts-run .unit{text-anchor:end}.vrts-run .time{text-anchor:middle}"
    ".vrts-run .grid{stroke:currentColor;opacity:.18}"
    ".vrts-run .zero{stroke:currentColor;opacity:.5}"
    ".vrts-run polyline{fill:none;stroke-width:1.6}"
    + "".join(
        f".vrts-run .s{k}{{stroke:{color}}}.vrts-run .t{k}{{fill:{color};font-weight:600}}"
        for k, color in enumerate(COLORS)
    )
)


def curves(words: str, times: Array, joints_deg: Array, tool_mm: Array) -> str:
    """Return joints and tool of a run over time as one fragment of HTML.

    Args:
        words: What is said above the curves.
        times: Shape (n,) [s].
        joints_deg: Shape (n, 6) [deg].
        tool_mm: X, Y and Z, shape (n, 3) [mm].
    """
    parts = [raw("style", STYLE), element("p", words)]
    if float(np.ptp(times)) > 0.0:
        angles = [(f"JT{k + 1}", joints_deg[:, k]) for k in range(joints_deg.shape[1])]
        places = [(axis, tool_mm[:, k]) for k, axis in enumerate("XYZ")]
        parts += [series_figure(times, angles, "degrees"), series_figure(times, places, "mm")]
    return element("div", *parts, class_="vrts-run")
