"""The models by name.

`val2` and `vplus` follow the documents; `readings` says which, field by field. `vrts-1` is what
vrts did before controllers had models; it never changes, so that what was saved then replays to the
same answer.
"""

from dataclasses import replace

from vrts.controllers.model import (
    AlignTurn,
    Branches,
    ControllerModel,
    Corners,
    CornerShape,
    Lines,
    LineTurn,
    NextMotion,
    NoLength,
    Pace,
    Programs,
    Settling,
    Stops,
    TurnMeasure,
    WristChoice,
)

VRTS_1 = ControllerModel(
    name="vrts-1",
    title="vrts before controllers had models",
    pace=Pace(
        tick_s=0.028,
        departure_ticks=1,
        acceleration_s=None,
        least_accelerations=2.0,
        no_length=NoLength.BY_KIND,
        most_speed_percent=100.0,
        most_monitor_percent=100.0,
        brake_accelerations=1.0,
        monitor_accelerations=1.0,
        pendant_percent=25.0,
    ),
    corners=Corners(shape=CornerShape.QUARTIC, half_accelerations=1.0, whole_s=None),
    lines=Lines(turn=LineTurn.TWO_TURNS, measure=TurnMeasure.LARGER, align=AlignTurn.SMALLEST),
    stops=Stops(
        settling=Settling.WAITS,
        fine_ticks=3,
        coarse_ticks=1,
        branch_words_wait=True,
    ),
    next_motion=NextMotion(
        delay_uses_settings=False,
        delay_moves_hand=False,
        drive_uses_speed=False,
    ),
    programs=Programs(steps_a_tick=100, hand_s=None, pulse_s=0.2),
    branches=Branches(
        wrist=WristChoice.NEAREST,
        shoulder_boundary_m=25e-3,
        elbow_boundary_m=25e-3,
        wrist_boundary_deg=0.01,
    ),
)

VAL2 = replace(
    VRTS_1,
    name="val2",
    title="VAL-II, as far as the documents go",
    pace=VRTS_1.pace._replace(no_length=NoLength.NO_TIME),
    lines=VRTS_1.lines._replace(measure=TurnMeasure.TRUE),
    stops=VRTS_1.stops._replace(settling=Settling.EVERY_STOP),
    next_motion=VRTS_1.next_motion._replace(delay_uses_settings=True, delay_moves_hand=True),
)

VPLUS = replace(
    VAL2,
    name="vplus",
    title="V+, as far as the documents go",
    pace=VAL2.pace._replace(tick_s=0.016),
    stops=VAL2.stops._replace(branch_words_wait=False),
)

FIRST = VRTS_1  # of files that were made before they said which model they go by
USUAL = VAL2  # of runs for which nobody names one

MODELS = {model.name: model for model in (VAL2, VPLUS, VRTS_1)}


def model(name: str) -> ControllerModel:
    """Return the model of a name. Raises KeyError when there is none."""
    return MODELS[name]
