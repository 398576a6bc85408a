"""How the viewer arranges a recording."""

from functools import lru_cache
from typing import cast

import rerun as rr
import rerun.blueprint as rrb
from rerun.chunk import Chunk

from vrts.base.pose import Vector
from vrts.report.recording.names import TIMELINE
from vrts.report.recording.static import static_chunk

EYE: Vector = (2.9, -2.3, 0.9)  # in W [m]
TARGET: Vector = (0.55, 0.0, -0.1)
BACKGROUND = (58, 66, 77)
ROOM = 1.06  # of an axis: the curve ends a little before the frame


class Written(rrb.Blueprint):
    """A blueprint that is put into words once, and told to every recording."""

    def __init__(self, whole: rrb.Blueprint) -> None:
        """Take a blueprint; no recording is opened, no thread started."""
        self.__dict__.update(vars(whole))
        words = _Words()
        whole._log_to_stream(cast(rr.RecordingStream, words))  # pyright: ignore[reportPrivateUsage]
        self._chunks = words.chunks

    def _log_to_stream(self, stream: rr.RecordingStream) -> None:
        rr.send_chunks(self._chunks, recording=stream)


class _Words:
    """What a blueprint would say to a recording."""

    def __init__(self) -> None:
        self.chunks: list[Chunk] = []

    def log(self, path: str, thing: rr.AsComponents) -> None:
        first = rr.TimeColumn("blueprint", sequence=[0])
        self.chunks.append(static_chunk(path, thing, at=[first]))


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
    whole = rrb.Blueprint(
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
    return Written(whole)


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
