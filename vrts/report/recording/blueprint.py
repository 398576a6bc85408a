"""How the viewer arranges a recording."""

from functools import lru_cache

import rerun.blueprint as rrb

from vrts.base.pose import Vector
from vrts.report.recording.names import TIMELINE

EYE: Vector = (2.9, -2.3, 0.9)  # in W [m]
TARGET: Vector = (0.55, 0.0, -0.1)
BACKGROUND = (58, 66, 77)
ROOM = 1.06  # of an axis: the curve ends a little before the frame


@lru_cache(maxsize=8)
def blueprint(opening_max_mm: float) -> rrb.Blueprint:
    """Return the scene with lanes and log on the left, curves and summary on the right.

    The axes of time show all there is, so that every run of a robot has the same blueprint.

    Args:
        opening_max_mm: How far the hand opens.
    """
    scene = rrb.Spatial3DView(
        origin="/world",
        name="Scene",
        background=BACKGROUND,
        line_grid=False,
        eye_controls=rrb.EyeControls3D(position=EYE, look_target=TARGET),
    )
    lanes = rrb.StateTimelineView(
        origin="/lanes", name="Lines, gripper and signals", time_view=_whole()
    )
    log = rrb.TextLogView(
        origin="/log",
        name="Program",
        columns=rrb.TextLogColumns(text_log_columns=["LogLevel", "Body"]),
    )
    percent = (-100.0 * ROOM, 100.0 * ROOM)
    curves = [
        rrb.Tabs(
            _curves("range", "Joints [% of half the range]", percent),
            _curves("joints", "Joints [deg]", None),
        ),
        _curves("speed", "Joint speed [% of limit]", percent),
        _curves("clearance", "Clearance [mm]", None),
        _curves("hand", "Hand opening [mm]", (0.0, ROOM * opening_max_mm)),
    ]
    return rrb.Blueprint(
        rrb.Horizontal(
            rrb.Vertical(scene, lanes, log, row_shares=[6, 2, 2]),
            rrb.Vertical(
                *curves,
                rrb.TextDocumentView(origin="/summary", name="Summary"),
                row_shares=[3, 3, 3, 2, 2],
            ),
            column_shares=[3, 2],
        ),
        rrb.TimePanel(timeline=TIMELINE, state="collapsed"),
        collapse_panels=True,
    )


def _curves(path: str, name: str, levels: tuple[float, float] | None) -> rrb.TimeSeriesView:
    return rrb.TimeSeriesView(
        origin=f"/{path}",
        name=name,
        axis_x=_whole(),
        axis_y=rrb.ScalarAxis(range=levels) if levels else None,
        plot_legend=rrb.PlotLegend(visible=path in ("range", "joints")),
    )


def _whole() -> rrb.TimeAxis:
    """Return an axis that shows the whole run."""
    everything = rrb.TimeRangeBoundary.infinite()
    return rrb.TimeAxis(view_range=rrb.TimeRange(start=everything, end=everything))
