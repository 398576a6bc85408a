"""Why a mark is unsafe, so that nobody should take it for final: the one place that decides."""

from collections.abc import Collection, Iterable, Iterator
from enum import Enum
from typing import Annotated

from msgspec import Meta

from vrts.check.mark.grade import NOT_CHECKED, REVIEW
from vrts.check.task.manifest import ANOTHER_VERSION, IN_HIDDEN_SCENE
from vrts.marking.result import Kind, Record, Result

ALL = "all"  # in place of reasons: every one


class Reason(Enum):
    """Why a mark is unsafe, the most urgent first; the values are typed and written in files."""

    CRASHED = "crashed"  # vrts itself failed
    RESOURCE = "resource"  # the process was ended
    AMBIGUOUS = "ambiguous"  # nobody can tell which file is meant
    UNREAD = "unread"  # the file is there, and could not be read
    CONFLICT = "conflict"  # graders have decided differently
    LAPSED = "lapsed"  # what graders decided was about another program
    VARIANT = "variant"  # by whose numbers it has to be marked is not clear
    ALTERED = "altered"  # task, scene or controller are not those that were handed out
    VERSION = "version"  # another vrts than the task wants
    HIDDEN = "hidden"  # hidden checks were not made
    UNCHECKED = "unchecked"  # collisions were not looked for
    UNDETERMINED = "undetermined"  # a check cannot tell
    LATE = "late"  # whether it was late, or how late, is not known, and that may cost points


REASONS = tuple(reason.value for reason in Reason)
OF_GRADERS = frozenset({Reason.CONFLICT, Reason.LAPSED})  # only graders can decide these
SETTLED = tuple(reason.value for reason in Reason if reason not in OF_GRADERS)
WITHOUT_MARK = {
    Kind.FAULT: Reason.CRASHED,
    Kind.RESOURCE: Reason.RESOURCE,
    Kind.AMBIGUOUS: Reason.AMBIGUOUS,
    Kind.UNREAD: Reason.UNREAD,
}
TABLE = "`staff/intake.csv` (with pseudonyms: `staff/names.csv`)"
REMEDIES = {
    Reason.CRASHED: "send `fault.txt` beside the grader's report to the makers of vrts",
    Reason.RESOURCE: "mark it again with fewer `--jobs`, or where there is more memory",
    Reason.AMBIGUOUS: f"name the file that is meant in {TABLE}, and mark again",
    Reason.UNREAD: "make the file readable, or download it again, and mark again",
    Reason.CONFLICT: "`vrts grade decisions OUT` says who differs: decide with"
    " `--keep NAME --who YOU --reason WHY`, or undo one with `--undo NAME --who YOU`",
    Reason.LAPSED: "look at the program that is marked now, decide again, and undo what was"
    " decided before with `vrts grade decisions OUT --undo NAME --who YOU`",
    Reason.VARIANT: "look whose program it is, and decide; `variants.csv` of `vrts task variants`"
    " tells who has which",
    Reason.ALTERED: "mark again with the task that was handed out",
    Reason.VERSION: "mark again with a vrts that the task names",
    Reason.HIDDEN: "mark again with the staff's task, in which the hidden checks are",
    Reason.UNCHECKED: "mark again without `--no-collisions`",
    Reason.UNDETERMINED: "look at the report, and decide",
    Reason.LATE: "give the times with `--roster` (Moodle's grading worksheet), or in the column"
    f" `received` of {TABLE}, and mark again",
}


class Doubt(Record, frozen=True):
    """One reason why a mark is unsafe, and what is known about it."""

    reason: Reason
    sentence: Annotated[str, Meta(description="for those who mark")]


def doubts(
    result: Result, *, untimed: str = "", settled: Collection[str] = ()
) -> tuple[Doubt, ...]:
    """Return what makes the mark of a result unsafe, the most urgent first; nothing for a safe one.

    Args:
        result: For those who mark.
        untimed: Why nobody knows what lateness costs; "" where that is known.
        settled: Values of the reasons that somebody has decided, or `all`.
    """
    if ALL in settled:
        return ()
    found = dict.fromkeys(_found(result, untimed))
    return in_order(doubt for doubt in found if doubt.reason.value not in settled)


def in_order(found: Iterable[Doubt]) -> tuple[Doubt, ...]:
    """Return doubts, the most urgent first."""
    order = {reason: place for place, reason in enumerate(Reason)}
    return tuple(sorted(found, key=lambda doubt: order[doubt.reason]))


def _found(result: Result, untimed: str) -> Iterator[Doubt]:
    if result.kind in WITHOUT_MARK:
        for text in result.review or (result.cause,):
            yield Doubt(WITHOUT_MARK[result.kind], text)
        return
    if result.variant is not None and result.variant.doubt:
        yield Doubt(Reason.VARIANT, result.variant.doubt)
    for text in result.review:
        yield Doubt(Reason.UNDETERMINED, text.removeprefix(f"{REVIEW}: "))
    if result.mark is None:
        return
    if not result.review and result.lowest is not None and result.lowest < result.mark:
        between = f"the mark is between {result.lowest:g} and {result.mark:g}"
        yield Doubt(Reason.UNDETERMINED, between)
    for stamp in result.stamps:
        if not stamp.startswith(IN_HIDDEN_SCENE):  # which only tells where it was marked
            other = stamp.startswith(ANOTHER_VERSION)
            yield Doubt(Reason.VERSION if other else Reason.ALTERED, stamp)
    if result.more:
        words = "1 hidden check was" if result.more == 1 else f"{result.more} hidden checks were"
        yield Doubt(Reason.HIDDEN, f"{words} not made")
    if result.mark and NOT_CHECKED in result.obstacles:
        yield Doubt(Reason.UNCHECKED, NOT_CHECKED)
    if result.mark and untimed:
        yield Doubt(Reason.LATE, untimed)
