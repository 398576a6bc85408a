"""Lists of a class that platforms export: who is in it, and with Moodle when their work came.

Moodle's grading worksheet tells ids, names, addresses and times; Canvas's grade book ids, names and
logins. Headers are of the platform's language, so what is in a column counts where they are not
known.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime, tzinfo
from typing import NamedTuple

from vrts.marking.intake.layouts.hand_in import HandIn, Layout
from vrts.marking.intake.row import Platform, Student, plain_id
from vrts.marking.intake.tables.local_time import local_time
from vrts.marking.intake.tables.table_text import Cell, read_text, table
from vrts.pipeline.files import CannotRead

LARGEST = 16_000_000  # bytes
CANVAS_HEADER = ("student", "id")
PLAIN_NAMES = ("name", "full name")  # columns of a table that somebody wrote
PLAIN_EMAILS = ("email", "e-mail", "email address", "mail")
KNOWN = (
    "name",
    "email",
    "identifier",
    "full name",
    "email address",
    "status",
    *CANVAS_HEADER,
    "section",
)

_PARTICIPANT = re.compile(r"[^\d@]+?(\d+)$")  # "Participant 123456", "Teilnehmer/in123456"
_ADDRESS = re.compile(r"[^@\s]+@[^@\s]+$")
_DRAFT = re.compile(  # "Draft (not submitted)": saved, and the student never said that it counts
    r"(draft|entwurf|brouillon|borrador|bozza|concept|rascunho|taslak)\b[^()]*\(", re.IGNORECASE
)
_GRADED = re.compile(r"grade|bewert|note|calific|valut|beoord|avalia", re.IGNORECASE)


class Member(NamedTuple):
    """Somebody in the class."""

    student: Student
    received: datetime | None  # when the work came, if the list tells


class Roster(NamedTuple):
    """A class."""

    platform: Platform
    members: Mapping[str, Member]  # by their id on the platform
    remarks: tuple[str, ...]


def read_roster(data: bytes, name: str, zone: tzinfo | None) -> Roster:
    """Return the class of a grading worksheet of Moodle, a grade book of Canvas, or a plain table.

    A plain table has columns `name` and `email`, and if you like `id`.

    Args:
        data: Content of the list.
        name: As shown.
        zone: In which Moodle shows its times; None: they are left out.

    Raises:
        CannotRead: It is neither.
    """
    lines = table(read_text(data[:LARGEST], name), KNOWN)
    header = [cell.text.strip().casefold() for cell in lines[0]] if lines else []
    if tuple(header[:2]) == CANVAS_HEADER:
        return _canvas(header, lines[1:])
    if len(lines) > 1 and all(_PARTICIPANT.match(line[0].text.strip()) for line in lines[1:]):
        return _moodle(header, lines[1:], name, zone)
    if header and "identifier" not in header:
        plain = _plain(header, lines[1:])
        if plain is not None:
            return plain
    hint = "export Moodle's grading worksheet, or the grade book of Canvas"
    raise CannotRead(f"`{name}` is no list of a class", (hint,))


def enrolled(layout: Layout, roster: Roster) -> Layout:
    """Return a layout with what a list tells of its students, and hand-ins of who is absent."""
    platform = roster.platform.value
    called = {
        name.casefold(): number
        for number, member in roster.members.items()
        for name in (
            member.student.email,
            member.student.login,
            f"{platform}-{number}",
            f"id-{number}",
        )
        if name
    }

    def number_of(hand_in: HandIn) -> str:
        """Return the id of whose it is: as the platform says, or as folders of hand-ins do."""
        own = hand_in.student.ids.get(platform, "")
        return own or called.get(
            hand_in.student.email.casefold() or hand_in.words[0].casefold(), ""
        )

    if not any(number_of(hand_in) for hand_in in layout.hand_ins):
        remark = "the list of the class is not used: nobody whose work is here is in it"
        return layout._replace(remarks=(*layout.remarks, remark))
    seen: set[str] = set()
    hand_ins: list[HandIn] = []
    remarks = list(roster.remarks)
    for hand_in in layout.hand_ins:
        number = number_of(hand_in)
        member = roster.members.get(number)
        if member is None:
            remarks.append(f"`{' '.join(hand_in.words)}` is not in the list of the class")
            hand_ins.append(hand_in)
            continue
        seen.add(number)
        ids = {**hand_in.student.ids, **member.student.ids}
        hand_ins.append(
            hand_in._replace(
                student=replace(member.student, ids=ids),
                received=hand_in.received or member.received,
            )
        )
    hand_ins += [
        HandIn(number, (member.student.name, number), member.student, ())
        for number, member in roster.members.items()
        if number not in seen
    ]
    return layout._replace(hand_ins=tuple(hand_ins), remarks=(*layout.remarks, *remarks))


def _plain(header: Sequence[str], lines: Sequence[Sequence[Cell]]) -> Roster | None:
    """Return the class of a table that somebody wrote; None: it is none."""
    names, emails = ({*header} & {*known} for known in (PLAIN_NAMES, PLAIN_EMAILS))
    if not names or not (emails or "id" in header):
        return None
    name, email = names.pop(), emails.pop() if emails else ""
    members: dict[str, Member] = {}
    for line in lines:
        cells = dict(zip(header, (cell.text.strip() for cell in line), strict=False))
        address = cells.get(email, "").casefold()
        number = plain_id(cells.get("id", "")) or address
        if cells.get(name) and number:
            ids = {Platform.SIS.value: number} if number != address else {}
            members[number] = Member(Student(cells[name], address, ids=ids), None)
    return Roster(Platform.SIS, members, ())


def _canvas(header: Sequence[str], lines: Sequence[Sequence[Cell]]) -> Roster:
    members: dict[str, Member] = {}
    for line in lines:
        cells = dict(zip(header, (cell.text.strip() for cell in line), strict=False))
        number = cells.get("id", "")
        if not number.isdecimal():
            continue  # points possible, and the like
        ids = {Platform.CANVAS.value: number}
        if cells.get("sis user id"):
            ids[Platform.SIS.value] = plain_id(cells["sis user id"])
        student = Student(cells["student"], login=cells.get("sis login id", ""), ids=ids)
        members[number] = Member(student, None)
    return Roster(Platform.CANVAS, members, ())


def _moodle(
    header: Sequence[str], lines: Sequence[Sequence[Cell]], name: str, zone: tzinfo | None
) -> Roster:
    times = _column_of_times(header, lines)
    members: dict[str, Member] = {}
    drafts: list[str] = []
    for line in lines:
        cells = [cell.text.strip() for cell in line]
        found = _PARTICIPANT.match(cells[0])
        assert found is not None, "looked at before"
        email = next((cell for cell in cells[1:] if _ADDRESS.match(cell)), "")
        # blind marking has no names
        named = len(cells) > 1 and len(header) > 1 and header[1] not in ("status", "email address")
        full = cells[1] if named else ""
        student = Student(full or cells[0], email, ids={Platform.MOODLE.value: found[1]})
        time = None
        told = (cell for cell in cells[1 + named :] if cell and not _ADDRESS.match(cell))
        if _DRAFT.match(next(told, "")):  # the status; the time is not that of a hand-in
            drafts.append(f"`{student.name}`")
        elif times is not None and times < len(cells) and zone is not None:
            time = local_time(cells[times], zone)
        members[found[1]] = Member(student, time)
    remarks: tuple[str, ...] = ()
    if times is not None and zone is None:
        remarks = (f"the times in `{name}` have no zone, so they do not count: give one",)
    if drafts:
        what = "is a draft" if len(drafts) == 1 else "are drafts"
        remarks += (f"what `{name}` has of {', '.join(drafts)} {what} and was not submitted",)
    return Roster(Platform.MOODLE, members, remarks)


def _column_of_times(header: Sequence[str], lines: Sequence[Sequence[Cell]]) -> int | None:
    """Return the column that tells when work came; the one of grades has times too."""
    for column, title in enumerate(header):
        if _GRADED.search(title):
            continue
        texts = (line[column].text for line in lines if column < len(line))
        if any(local_time(text, UTC) is not None for text in texts):
            return column
    return None
