"""What of a class stays at home while it is marked elsewhere: all that lists of marks need."""

from msgspec import field

from vrts.marking.intake.row import Row
from vrts.marking.marking import Entry
from vrts.marking.result import Record
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place


class AtHome(Record, frozen=True):
    """A class, beside its results."""

    place: Place  # of the task; its paths are absolute
    submissions: tuple[str, ...]  # as they were named
    wanted: Wanted
    found: tuple[Row, ...]  # who handed in what
    entries: tuple[Entry, ...]  # beside them, with the programs
    remarks: tuple[str, ...]  # of the intake
    intake: bytes  # the table of `found`
    edited: bool  # whether a teacher's table was obeyed
    variants: dict[str, bytes] = field(default_factory=dict[str, bytes])  # packed tasks by tag
    doubts: dict[str, str] = field(default_factory=dict[str, str])  # of a variant's being right
    attempts: tuple[Row, ...] = ()  # the rows before attempts were chosen
