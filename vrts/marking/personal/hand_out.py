"""All that markings keep of one student, as one zip; nothing of anybody else is in it."""

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Final, NamedTuple

import msgspec

from vrts.base.safe_names import safe
from vrts.base.zips import packed
from vrts.marking.appeals.written import Written, read_written
from vrts.marking.by_hand.by_hand import ByHand
from vrts.marking.by_hand.decisions.about_one import about_student
from vrts.marking.by_hand.decisions.records import Comment
from vrts.marking.exports.feedback import for_student
from vrts.marking.exports.marks_table import NAME as MARKS
from vrts.marking.exports.marks_table import marks_csv
from vrts.marking.exports.write import is_name
from vrts.marking.intake.tables.intake_table import COLUMNS
from vrts.marking.intake.tables.table_text import read_text, table, table_bytes
from vrts.marking.layout import LOST, RESULT, STAFF, Layout
from vrts.marking.personal.kept import plain_words
from vrts.marking.personal.likeness_of_one import likeness_of
from vrts.marking.personal.whom import Whom, nobody, whom_in
from vrts.marking.privacy.pseudonyms import COLUMN, NAMES
from vrts.marking.renewing.renewed import brought_up_to_date
from vrts.marking.result import to_bytes as result_to_bytes
from vrts.marking.row import Class, Row
from vrts.marking.similarity.kept import place_of, read_kept
from vrts.marking.submission.sketch import SKETCH
from vrts.marking.submission.sketch import to_bytes as sketch_to_bytes
from vrts.marking.unsafe import Doubt, Reason
from vrts.pipeline.files import read_bytes

README: Final = """\
What markings with vrts keep of {name}
{line}

{places}
In each folder:

students/        what may be sent to you: feedback, report, recording, result
staff/           the result for those who mark, with checks that are hidden in the task
row.json         your row in the list of marks: name, addresses, mark, why, your variant
marks.csv        the same as a table
intake.csv       your line in the table of hand-ins; names.csv: with your pseudonym
decisions.json   what graders decided and wrote about you
changes.json     changes of your mark by hand
program.v2       your program, as it is kept to be compared; motion.json: what its run did
likeness.json    programs that are like yours; the others are not named

Graders are named only where your report names them. {private}
What is not here was not kept, or is of others.

What is kept, what for, and how long
====================================

{table}"""
OTHERS: Final = {  # in place of sentences that name graders, or other students
    Reason.CONFLICT: "graders have not settled this yet",
    Reason.LAPSED: "graders have not settled this yet",
    Reason.VARIANT: "the program may be made for another variant",
}
NAMED_BY: Final = ("comment", "give")  # records of which a report says who wrote them
MODE: Final = 0o600


class HandedOut(NamedTuple):
    """What was packed."""

    data: bytes  # of the zip
    files: int
    found: tuple[str, ...]  # folders in which the student is
    private: int  # comments that are left out, for those who mark only


def hand_out(folders: Sequence[Path], wanted: str) -> HandedOut:
    """Return a zip of all that markings keep of a student; its first member says what is what.

    Pages and lists are brought up to date with what graders have decided.

    Args:
        folders: Of markings that have ended.
        wanted: Id or pseudonym of the student; or a name or an address that only one has.

    Raises:
        CannotRead: A file cannot be read.
        Refused: A folder is no such marking, or there is nobody of that id in any of them.
    """
    members: dict[str, bytes] = {}
    homes: list[str] = []
    found: list[str] = []
    private, name = 0, ""
    for folder in folders:
        whom = whom_in(folder, wanted)
        if whom is None:
            continue
        brought_up_to_date(read_written(folder))
        home = _home(folder, homes)
        homes.append(home)
        found.append(str(folder))
        name = name or next((one for one in whom.names if one not in whom.ids), whom.id)
        written = read_written(folder)
        by_hand = written.by_hand()
        private += _private(by_hand, whom.id)
        members |= {f"{home}/{file}": data for file, data in _files(written, by_hand, whom)}
    if not homes:
        raise nobody(folders[0], wanted)
    said = f"{private} private comments of graders are left out. " if private else ""
    places = "".join(f"{home}/\n" for home in homes)
    heading = README.format(
        name=name, line="=" * (31 + len(name)), places=places, private=said, table=plain_words()
    )
    data = packed({"README.txt": heading.encode(), **members}, MODE)
    return HandedOut(data, len(members) + 1, tuple(found), private)


def _home(folder: Path, taken: Sequence[str]) -> str:
    first = name = safe(folder.resolve().name)
    number = 2
    while name in taken:
        name, number = f"{first}-{number}", number + 1
    return name


def _files(written: Written, by_hand: ByHand, whom: Whom) -> Iterator[tuple[str, bytes]]:
    layout = written.layout
    row = _for_student(written.row(whom.id))
    yield from _pages(layout, whom)
    yield f"{STAFF}/{RESULT}", result_to_bytes(row.result)
    yield "row.json", _laid_out(msgspec.to_builtins(row))
    yield MARKS, marks_csv(Class("vrts.class/1", written.rows.title, (row,)))
    for place in (layout.intake, layout.staff / NAMES):
        line = _line(place, whom)
        if line is not None:
            yield place.name, line
    said = about_student(by_hand.ledger, whom.id)
    if said:
        yield "decisions.json", _laid_out(_without_graders(said))
    made = by_hand.overrides.changes.get(whom.id, ())
    if made:
        changes = [
            {
                "delta": None if one.delta is None else str(one.delta),
                "mark": None if one.mark is None else str(one.mark),
                "reason": one.reason,
                "date": one.date,
            }
            for one in made
        ]
        yield "changes.json", _laid_out(changes)
    place = place_of(layout)
    own = read_kept(place).programs.get(whom.id) if place.is_file() else None
    if own is not None:
        yield "program.v2", own.data
        if own.sketch is not None:
            yield SKETCH, sketch_to_bytes(own.sketch)
    alike = likeness_of(layout, whom.ids)
    if alike is not None:
        yield "likeness.json", _laid_out(alike)


def _pages(layout: Layout, whom: Whom) -> Iterator[tuple[str, bytes]]:
    """Yield the files that may be sent to the student, and the result for those who mark."""
    if not is_name(whom.id):
        return
    home = layout.student(whom.id)
    for path in sorted(home.rglob("*")) if not home.is_symlink() else ():
        if path.is_file() and not path.is_symlink():
            yield f"students/{path.relative_to(home).as_posix()}", path.read_bytes()
    path = layout.grader(whom.id) / LOST
    if path.is_file() and not path.is_symlink():
        yield f"{STAFF}/{LOST}", path.read_bytes()


def _for_student(row: Row) -> Row:
    """Return a row in which graders stand only where the student's own report names them."""
    decided = for_student(row)
    if decided is not None:
        decided = msgspec.structs.replace(decided, conflicts=(), lapsed=(), again="", result=None)
    change = None if row.change is None else msgspec.structs.replace(row.change, who="")
    result = row.result if row.decided is None else row.decided.result or row.result
    if result.variant is not None:
        doubt = result.variant.doubt  # it says whose variant the program is made for
        variant = msgspec.structs.replace(result.variant, doubt="")
        review = tuple(text for text in result.review if not doubt or doubt not in text)
        result = msgspec.structs.replace(result, variant=variant, review=review)
    unsafe = tuple(Doubt(one.reason, OTHERS.get(one.reason, one.sentence)) for one in row.unsafe)
    return msgspec.structs.replace(
        row, result=result, decided=decided, change=change, unsafe=unsafe
    )


def _line(place: Path, whom: Whom) -> bytes | None:
    """Return the line of a table about a student, under its header; None without one."""
    if not place.is_file() or place.is_symlink():
        return None
    rows = table(read_text(read_bytes(place), place.name), (*COLUMNS, COLUMN))
    texts = [[cell.text for cell in row] for row in rows]
    heads = [text.strip().casefold() for text in texts[0]] if texts else []
    at = [heads.index(column) for column in ("id", COLUMN) if column in heads]
    mine = [
        line for line in texts[1:] if any(k < len(line) and line[k].strip() in whom.ids for k in at)
    ]
    return table_bytes((texts[0], *mine)) if mine else None


def _without_graders(said: bytes) -> list[dict[str, object]]:
    """Return records without who wrote them, except where a report says so; names are numbers."""
    records = [json.loads(line) for line in said.splitlines()]
    numbers = {one["record"]: k for k, one in enumerate(records, 1)}
    told: list[dict[str, object]] = []
    for one in records:
        plain = {key: value for key, value in one.items() if key not in ("record", "number")}
        if plain.get("does") not in NAMED_BY:
            plain.pop("grader", None)
        if plain.get("does") == "assign":
            plain["graders"] = len(plain.get("graders", ()))
        for key in ("records", "over", "after"):
            if key in plain:
                plain[key] = [numbers[name] for name in plain[key] if name in numbers]
        if "keep" in plain:
            plain["keep"] = numbers.get(plain["keep"])
        told.append({"record": numbers[one["record"]], **plain})
    return told


def _private(by_hand: ByHand, student: str) -> int:
    said = (one.said for one in by_hand.ledger.records)
    return sum(isinstance(s, Comment) and s.private and s.student == student for s in said)


def _laid_out(value: object) -> bytes:
    return msgspec.json.format(msgspec.json.encode(value), indent=1) + b"\n"
