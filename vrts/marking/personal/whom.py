"""Who is to be forgotten in one marking, written down until that has ended."""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Final, Literal

import msgspec

from vrts.marking.appeals.written import Written, no_marking, read_written
from vrts.marking.by_hand.decisions.state import students_of
from vrts.marking.exports.write import is_name
from vrts.marking.intake.tables.intake_table import NAME as INTAKE
from vrts.marking.layout import FORGETTING, Layout, write_atomically
from vrts.marking.privacy.others import is_nameless
from vrts.marking.privacy.pseudonyms import NAMES, key_for, pseudonym, read_names, with_names
from vrts.marking.result import Damaged, Record, decoded
from vrts.marking.row import Row
from vrts.marking.similarity.files import PAGE
from vrts.marking.whole_class import was_edited
from vrts.pipeline.files import read_bytes
from vrts.pipeline.refused import Refused

SCHEMA: Final = "vrts.forgetting/1"
SEVERAL = 1  # rows of one name


class Whom(Record, frozen=True):
    """A student in a marking, as its files name them, and what has to be done after them."""

    schema: Literal["vrts.forgetting/1"]
    id: str  # of the row; "": nobody of this class, but pages show programs of another one
    ids: tuple[str, ...] = ()  # id, pseudonym, and id at home
    names: tuple[str, ...] = ()  # all by which files name them, ids too
    file: str = ""  # that they handed in
    tag: str = ""  # of their variant
    table: str = ""  # of hand-ins, which nobody has edited; "": somebody has
    compared: bool = False  # whether there are pages about likeness
    corpora: tuple[str, ...] = ()  # folders to compare with again
    lost: tuple[str, ...] = ()  # names of those that are not found any more


def unfinished(layout: Layout) -> Whom | None:
    """Return whom a call was forgetting when it was interrupted; None: there was none.

    Raises:
        Refused: It cannot be read.
    """
    place = layout.staff / FORGETTING
    if not os.path.lexists(place):
        return None
    try:
        return decoded(b"" if place.is_symlink() else read_bytes(place), Whom)
    except Damaged as problem:
        raise no_marking(layout.root, f"`{FORGETTING}` is not as vrts writes it") from problem


def write_down(whom: Whom, layout: Layout) -> None:
    """Write who is being forgotten, before anything else is changed."""
    write_atomically(layout.staff / FORGETTING, msgspec.json.encode(whom))


def strike_out(layout: Layout) -> None:
    """Delete what was written down: it has ended."""
    (layout.staff / FORGETTING).unlink(missing_ok=True)


def whom_in(folder: Path, wanted: str) -> Whom | None:
    """Return a student of a marking; None: nobody is called so.

    Args:
        folder: Of a marking that has ended.
        wanted: Id or pseudonym; or a name or an address that only one has.

    Raises:
        Refused: There is no such marking, or several are called so.
    """
    written = read_written(folder)
    found = _rows(written, wanted)
    if len(found) > SEVERAL:
        written.row(wanted)  # says who they are
    return _whom(written, found[0], wanted) if found else None


def left_of(folder: Path, wanted: str) -> Whom | None:
    """Return somebody who has no row any more, and of whom something is left; None: nothing is.

    They were in an earlier marking into this folder, or a grader decided about them afterwards.

    Args:
        folder: Of a marking that has ended.
        wanted: Id, exactly.
    """
    written = read_written(folder)
    layout, by_hand = written.layout, written.by_hand()
    if not is_name(wanted):
        return None
    homes = (layout.student(wanted), layout.grader(wanted))
    if not (
        any(home.is_dir() for home in homes)
        or wanted in by_hand.overrides.changes
        or any(wanted in students_of(one.said) for one in by_hand.ledger.records)
    ):
        return None
    compared = (layout.staff / PAGE).is_file()
    return Whom(SCHEMA, wanted, (wanted,), (wanted,), table=_table(layout), compared=compared)


def nobody(folder: Path, wanted: str) -> Refused:
    """Return that nobody of a marking is called so, and who may be meant."""
    try:
        read_written(folder).row(wanted)
    except Refused as refused:
        return refused
    raise AssertionError("somebody is")


def nobody_here(layout: Layout) -> Whom:
    """Return that only programs are to be compared again."""
    return Whom(SCHEMA, "", compared=(layout.staff / PAGE).is_file())


def _rows(written: Written, wanted: str) -> Sequence[Row]:
    found = written.rows_called(wanted)
    if not found and is_nameless(written.layout):
        name = pseudonym(wanted, key_for(written.layout))
        found = [row for row in written.rows.rows if row.id == name]
    return found


def _table(layout: Layout) -> str:
    """Return the table of hand-ins, which nobody has edited; "" where somebody has."""
    table = NAMES if is_nameless(layout) else INTAKE
    place = layout.staff / table
    return table if place.is_file() and not was_edited(layout, place) else ""


def _whom(written: Written, row: Row, wanted: str) -> Whom:
    layout = written.layout
    line = read_names(layout).get(row.id, {})
    (named,) = with_names(msgspec.structs.replace(written.rows, rows=(row,)), layout).rows
    student = named.student
    nameless = is_nameless(layout)
    home = line.get("id", "") or (wanted if nameless and not line and wanted != row.id else "")
    ids = tuple(dict.fromkeys(one for one in (row.id, home) if one))
    names = (*ids, student.name, student.email, student.login, *student.ids.values())
    variant = row.result.variant
    return Whom(
        SCHEMA,
        row.id,
        ids,
        tuple(dict.fromkeys(name.strip() for name in names if name.strip())),
        line.get("file", "") or row.handed_in.file,
        "" if variant is None else variant.tag,
        _table(layout),
        (layout.staff / PAGE).is_file(),
    )
