"""Buttons of a page that show a moment in its replay."""

from vrts.base.diagnostic import Moment
from vrts.report.page.html import Markup, element
from vrts.report.quantities import at_time, seconds, when


def moment_button(moment: Moment) -> Markup:
    """Return a button that shows a moment, and says so where a contact is deepest."""
    return watch_button(moment.time_s, when(moment) if moment.deepest else None)


def watch_button(time_s: float, text: str | None = None) -> Markup:
    """Return a button that shows a moment in the replay, a second before it happens."""
    label = text or f"{time_s:.1f} s"
    return element(
        "button",
        label,
        type="button",
        class_="seek",
        data_t=seconds(time_s),
        title=f"Show the replay {at_time(time_s)}",
    )
