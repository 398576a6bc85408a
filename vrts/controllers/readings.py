"""What every field of a model rests on: status, source and rule of the manual, as data.

The three statuses are those of `manual/understand/sources.md`. Where a model has another value
than the usual one, it has a ground of its own.
"""

from collections.abc import Mapping
from enum import Enum
from types import MappingProxyType
from typing import Literal, NamedTuple, TypeAlias

from vrts.controllers.values import Value

Status: TypeAlias = Literal["documented", "inferred", "assumed"]

BEFORE = "vrts before controllers had models"


class Ground(NamedTuple):
    """Why a value was taken."""

    status: Status
    source: str


class Reading(NamedTuple):
    """One field of a model."""

    field: str  # "pace.tick_s"
    unit: str  # empty: a number without one, or words
    about: str  # what it answers
    rule: str  # of the manual: page and rule
    ground: Ground  # of the usual value
    others: Mapping[str, Ground] = MappingProxyType({})  # of other values, by model


def _assumed(source: str) -> Ground:
    return Ground("assumed", source)


def _inferred(source: str) -> Ground:
    return Ground("inferred", source)


_FIRST = {"vrts-1": _assumed(BEFORE)}

READINGS = (
    Reading(
        "pace.tick_s",
        "s",
        "time between set points",
        "language/motion#tick",
        _inferred("[FGL1987] section 5.3.1, remembered"),
        {"vplus": _assumed("V+ has 16 ms as far as it is remembered; no document was found")},
    ),
    Reading(
        "pace.departure_ticks",
        "ticks",
        "from a motion instruction at rest to the start of its motion",
        "language/motion#ahead",
        _inferred("[VPlusGuide] on motion instructions: at the next tick"),
    ),
    Reading(
        "pace.acceleration_s",
        "s",
        "time from rest to full speed; none: as the robot's data say",
        "language/motion#time-scaling",
        _assumed("no document of VAL-II"),
    ),
    Reading(
        "pace.least_accelerations",
        "accelerations",
        "least time of a motion",
        "language/motion#time-scaling",
        _assumed("no document of VAL-II; so that both ends have room"),
    ),
    Reading(
        "pace.no_length",
        "",
        "how long a motion takes that goes nowhere",
        "language/motion#nowhere",
        _assumed("no document; the arm is there already"),
        {"vrts-1": _assumed(f"{BEFORE}: 0, 16 or 24 ticks, as it came")},
    ),
    Reading(
        "pace.most_speed_percent",
        "%",
        "a higher speed of the program acts as this",
        "language/settings#speed-limit",
        _assumed("no document of VAL-II; [VPlusReference] SPEED and [AS2015] 6-17"),
    ),
    Reading(
        "pace.most_monitor_percent",
        "%",
        "a higher speed of the operator acts as this",
        "language/settings#monitor-limit",
        _inferred("[VPlusReference] SPEED of the monitor"),
    ),
    Reading(
        "pace.brake_accelerations",
        "accelerations",
        "time of a stop from full speed",
        "language/motion#stops",
        _assumed("no document says how fast BRAKE is"),
    ),
    Reading(
        "pace.monitor_accelerations",
        "accelerations",
        "time of a change of the operator's speed",
        "language/settings#speed",
        _assumed("no document says how fast the change is"),
    ),
    Reading(
        "pace.pendant_percent",
        "%",
        "speed of the arm at the pendant's full speed",
        "robots/controllers#pendant",
        _assumed("no document"),
    ),
    Reading(
        "corners.shape",
        "",
        "how speed changes in a rounded corner",
        "language/motion#corners",
        _inferred("[Paul1981]"),
    ),
    Reading(
        "corners.half_accelerations",
        "accelerations",
        "half the time of a rounded corner",
        "language/motion#corners",
        _inferred("[Paul1981]"),
    ),
    Reading(
        "corners.whole_s",
        "s",
        "time of a rounded corner at full acceleration; none: as the robot's data say, or as above",
        "language/motion#corners",
        _assumed("no document"),
    ),
    Reading(
        "lines.turn",
        "",
        "how the tool turns along a line",
        "language/motion#line-turns",
        _assumed("no document says what VAL-II did; the formula: [Paul1981]"),
    ),
    Reading(
        "lines.measure",
        "",
        "the angle of two turns at once that the limit of turning speed is for",
        "language/motion#turning-speed",
        _assumed("no document; a limit of speed is kept by what turns: the tool"),
        _FIRST,
    ),
    Reading(
        "lines.align",
        "",
        "how ALIGN turns the hand about the tool's own axis",
        "language/motion#align",
        _assumed("the instruction: [VALIISlides]; which turn: no document"),
    ),
    Reading(
        "stops.settling",
        "",
        "when the controller waits until the joints are near enough",
        "language/settings#settling",
        _inferred("[VALSummary2014]: FINE and COARSE say when a motion's end is reached"),
        _FIRST,
    ),
    Reading(
        "stops.fine_ticks",
        "ticks",
        "settling with FINE",
        "language/settings#settling",
        _assumed("the words: [VALSummary2014]; the time: no document"),
    ),
    Reading(
        "stops.coarse_ticks",
        "ticks",
        "settling with COARSE",
        "language/settings#settling",
        _assumed("the words: [VALSummary2014]; the time: no document"),
    ),
    Reading(
        "stops.branch_words_wait",
        "",
        "RIGHTY and its like wait until the arm stands still",
        "language/motion#stops",
        _inferred("[AS2015] 4-16"),
        {"vplus": _inferred("[VPlusGuide] names them not among those that wait")},
    ),
    Reading(
        "next_motion.delay_uses_settings",
        "",
        "DELAY uses up SPEED, COARSE and their like for one motion",
        "language/motion#delay",
        _inferred("[AS2015] 6-4, [VALSummary2014]: DELAY is a motion"),
        _FIRST,
    ),
    Reading(
        "next_motion.delay_moves_hand",
        "",
        "OPEN and CLOSE act when a DELAY begins",
        "language/motion#delay",
        _inferred("[AS2015] 6-4, [VALSummary2014]: DELAY is a motion"),
        _FIRST,
    ),
    Reading(
        "next_motion.drive_uses_speed",
        "",
        "DRIVE uses up a SPEED for one motion, which it does not go by",
        "language/motion#drive",
        _assumed("no document"),
    ),
    Reading(
        "programs.steps_a_tick",
        "steps",
        "of each program in a tick",
        "language/processes#share",
        _assumed("no document"),
    ),
    Reading(
        "programs.hand_s",
        "s",
        "wait after OPENI and its like; none: the hand's whole stroke",
        "language/hand#at-once",
        _assumed("HAND.TIME: [RobotSandbox2010]; its value: no document"),
    ),
    Reading(
        "programs.pulse_s",
        "s",
        "time of PULSE without one",
        "language/signals#pulse",
        _assumed("[AS2015] has PULSE; the time: no document"),
    ),
    Reading(
        "branches.wrist",
        "",
        "which wrist a MOVE takes when none was asked for",
        "robots/branches#wrist",
        _assumed("no document"),
    ),
    Reading(
        "branches.shoulder_boundary_m",
        "m",
        "so near the shoulder's boundary the arm keeps the branch that it had",
        "robots/branches#boundary",
        _assumed("no document"),
    ),
    Reading(
        "branches.elbow_boundary_m",
        "m",
        "the same at the elbow's boundary",
        "robots/branches#boundary",
        _assumed("no document"),
    ),
    Reading(
        "branches.wrist_boundary_deg",
        "deg",
        "the same at the wrist's boundary, by joint 5",
        "robots/branches#boundary",
        _assumed("no document"),
    ),
)


def value_text(value: Value, unit: str = "") -> str:
    """Return a value in words."""
    match value:
        case None:
            return "none"
        case bool():
            return "yes" if value else "no"
        case Enum():
            return str(value.value)
        case _:
            return f"{value:g} {unit}".rstrip()
