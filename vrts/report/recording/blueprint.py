"""How the viewer arranges a recording."""

import rerun.blueprint as rrb

from vrts.report.recording.names import TIMELINE

EYE, TARGET = (3.4, -2.4, 1.3), (0.5, 0.0, -0.2)  # [m] in W


def blueprint() -> rrb.Blueprint:
    """Return the scene with lanes and log on the left, curves and summary on the right."""
    return rrb.Blueprint(
        rrb.Horizontal(
            rrb.Vertical(
                rrb.Spatial3DView(
                    origin="/world",
                    name="Scene",
                    eye_controls=rrb.EyeControls3D(position=EYE, look_target=TARGET),
                ),
                rrb.StateTimelineView(origin="/lanes", name="Lines, gripper and signals"),
                rrb.TextLogView(origin="/log", name="Program"),
                row_shares=[5, 2, 2],
            ),
            rrb.Vertical(
                rrb.Tabs(
                    rrb.TimeSeriesView(origin="/range", name="Joints [% of half the range]"),
                    rrb.TimeSeriesView(origin="/joints", name="Joints [deg]"),
                ),
                rrb.TimeSeriesView(origin="/speed", name="Joint speed [% of limit]"),
                rrb.TimeSeriesView(origin="/clearance", name="Clearance [mm]"),
                rrb.TimeSeriesView(origin="/hand", name="Hand opening [mm]"),
                rrb.TextDocumentView(origin="/summary", name="Summary"),
            ),
            column_shares=[3, 2],
        ),
        rrb.TimePanel(timeline=TIMELINE, state="expanded"),
        collapse_panels=True,
    )
