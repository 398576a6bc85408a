"""What graders have decided, as a list for people and for programs."""

from collections.abc import Iterable
from typing import Annotated, Literal

from msgspec import Meta, structs

from vrts.marking.by_hand.decisions.counting import counted
from vrts.marking.by_hand.decisions.ledger import Ledger
from vrts.marking.by_hand.decisions.records import Give, Name
from vrts.marking.by_hand.decisions.state import MARK, State, students_of
from vrts.marking.by_hand.decisions.words import sentence_of
from vrts.marking.result import Record
from vrts.marking.row import Row

SCHEMA: Literal["vrts.decided/1"] = "vrts.decided/1"
FILE = "file"  # what a conflict with `overrides.toml` is about


class Listed(Record, frozen=True):
    """One decision."""

    record: Name
    who: str
    at: Annotated[str, Meta(description="ISO 8601")]
    does: str
    students: tuple[str, ...]
    sentence: str
    undone_by: Annotated[str | None, Meta(description="name of the record")]
    lapsed: Annotated[
        tuple[str, ...], Meta(description="students for whom it is about another program")
    ] = ()


class Differing(Record, frozen=True):
    """Decisions that contradict each other, none of which counts."""

    about: str
    student: str
    sentence: str
    records: Annotated[
        tuple[Name, ...],
        Meta(description="none where `--keep` does not decide it, as with overrides.toml"),
    ]


class ItemListed(Record, frozen=True):
    """A rubric item as it is now."""

    id: str
    title: str
    points: float
    version: Name
    students: tuple[str, ...]
    withdrawn: bool


class Listing(Record, frozen=True):
    """All decisions of a class."""

    schema: Literal["vrts.decided/1"]
    decisions: tuple[Listed, ...]
    items: tuple[ItemListed, ...]
    conflicts: tuple[Differing, ...]


def listing(ledger: Ledger, state: State) -> Listing:
    """Return all that is decided.

    Args:
        ledger: Of the graders' files.
        state: The same, as it counts.
    """
    undone = counted(ledger.records).undone
    lapsed: dict[str, list[str]] = {}
    given: dict[str, list[str]] = {}
    for student, mine in state.students.items():
        for one in mine.lapsed:
            lapsed.setdefault(one.name, []).append(student)
        items_of = (one.said.item for one in mine.given if isinstance(one.said, Give))
        for item in dict.fromkeys(items_of):
            given.setdefault(item, []).append(student)
    decisions = tuple(
        Listed(
            one.name,
            one.who,
            one.said.at,
            str(one.said.__struct_config__.tag),
            students_of(one.said),
            sentence_of(one),
            undone.get(one.name),
            tuple(lapsed.get(one.name, ())),
        )
        for one in ledger.records
    )
    items = tuple(
        ItemListed(
            item.id,
            item.title,
            float(item.points),
            item.version,
            tuple(given.get(item.id, ())),
            item.withdrawn,
        )
        for item in state.items.values()
    )
    differing = tuple(
        Differing(one.about, one.student, one.sentence, tuple(side.name for side in one.sides))
        for one in state.conflicts
    )
    return Listing(SCHEMA, decisions, items, differing)


def with_file(told: Listing, rows: Iterable[Row]) -> Listing:
    """Return a listing with what contradicts `overrides.toml`, which is no grader's file.

    Args:
        told: What the files of graders say.
        rows: Of the class, with all that is decided.
    """
    known = {(one.student, one.sentence) for one in told.conflicts}
    added = tuple(
        Differing(FILE if "`overrides.toml`" in sentence else MARK, row.id, sentence, ())
        for row in rows
        for sentence in (() if row.decided is None else row.decided.conflicts)
        if (row.id, sentence) not in known and ("", sentence) not in known
    )
    return structs.replace(told, conflicts=(*told.conflicts, *added))
