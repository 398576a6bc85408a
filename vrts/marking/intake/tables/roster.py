"""Lists of a class that platforms export: who is in it, and with Moodle when their work came.

Moodle's grading worksheet tells ids, names, addresses and times; Canvas's grade book ids, names and
logins. Headers are of the platform's language, so what is in a column counts where they are not
known. Any list but Moodle's may have a column `received`, which somebody has added.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime, tzinfo
from typing import NamedTuple
from unicodedata import normalize

from vrts.marking.intake.layouts.hand_in import HandIn, Layout
from vrts.marking.intake.row import Platform, Student, plain_id
from vrts.marking.intake.tables.local_time import local_time
from vrts.marking.intake.tables.table_text import Cell, read_text, table
from vrts.pipeline.files import CannotRead

LARGEST = 16_000_000  # bytes
CANVAS_HEADER = ("student", "id")
PLAIN_NAMES = ("name", "full name")  # columns of a table that somebody wrote
PLAIN_EMAILS = ("email", "e-mail", "email address", "mail")
RECEIVED = "received"  # a column that somebody has added: when the work came
KNOWN = (
    "name",
    "email",
    "identifier",
    "full name",
    "email address",
    "status",
    *CANVAS_HEADER,
    "section",
    RECEIVED,
)

MOST_SHOWN = 5  # names or texts in a remark

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
        zone: Of its times that name none; None: these are left out.

    Raises:
        CannotRead: It is neither, or two in it have one id.
    """
    lines = table(read_text(data[:LARGEST], name), KNOWN)
    header = [cell.text.strip().casefold() for cell in lines[0]] if lines else []
    if tuple(header[:2]) == CANVAS_HEADER:
        return _canvas(header, lines[1:], name, zone)
    if header and "identifier" not in header:  # before Moodle's: ids as `m123` look like its own
        plain = _plain(header, lines[1:], name, zone)
        if plain is not None:
            return plain
    if len(lines) > 1 and all(_PARTICIPANT.match(line[0].text.strip()) for line in lines[1:]):
        return _moodle(header, lines[1:], name, zone)
    hint = "export Moodle's grading worksheet, or the grade book of Canvas"
    raise CannotRead(f"`{name}` is no list of a class", (hint,))


def enrolled(layout: Layout, roster: Roster) -> Layout:
    """Return a layout with what a list tells of its students, and hand-ins of who is absent."""
    platform = roster.platform.value
    called = _called(roster)

    def number_of(hand_in: HandIn) -> str:
        """Return the id of whose it is: as the platform says, or as folders of hand-ins do."""
        own = hand_in.student.ids.get(platform, "")
        return own or called.get(_alike(hand_in.student.email or hand_in.words[0]), "")

    if not any(number_of(hand_in) for hand_in in layout.hand_ins):
        remark = "the list of the class is not used: nobody whose work is here is in it"
        return layout._replace(remarks=(*layout.remarks, remark))
    seen: set[str] = set()
    hand_ins: list[HandIn] = []
    remarks = list(roster.remarks)
    latest = {number_of(hand_in): hand_in for hand_in in sorted(layout.hand_ins, key=_turn)}
    for hand_in in layout.hand_ins:
        number = number_of(hand_in)
        member = roster.members.get(number)
        if member is None:
            remarks.append(f"`{' '.join(hand_in.words)}` is not in the list of the class")
            hand_ins.append(hand_in)
            continue
        seen.add(number)
        ids = {**hand_in.student.ids, **member.student.ids}
        when = member.received if hand_in is latest[number] else None  # earlier ones came before
        hand_ins.append(
            hand_in._replace(
                student=replace(member.student, ids=ids), received=hand_in.received or when
            )
        )
    absent = {number: one for number, one in roster.members.items() if number not in seen}
    hand_ins += [
        HandIn(number, (member.student.name, number), member.student, ())
        for number, member in absent.items()
    ]
    lost = [one.student.name for one in absent.values() if one.received is not None]
    if lost:
        shown = ", ".join(f"`{name}`" for name in lost[:MOST_SHOWN])
        more = f" and {len(lost) - MOST_SHOWN} more" if len(lost) > MOST_SHOWN else ""
        what = "the list of the class tells when their work came, and no file of theirs is here"
        remarks.append(f"{shown}{more}: {what}; is the download whole?")
    return layout._replace(hand_ins=tuple(hand_ins), remarks=(*layout.remarks, *remarks))


def _turn(hand_in: HandIn) -> tuple[tuple[int, ...], tuple[str, ...]]:
    return hand_in.order, hand_in.files


def _called(roster: Roster) -> dict[str, str]:
    """Return ids by what hand-ins may be called; a name that two may mean is left out."""
    found: dict[str, set[str]] = {}
    for number, member in roster.members.items():
        names = (member.student.email, member.student.login)
        for name in (*names, f"{roster.platform.value}-{number}", f"id-{number}"):
            if name:
                found.setdefault(_alike(name), set()).add(number)
    return {name: numbers.pop() for name, numbers in found.items() if len(numbers) == 1}


def _alike(name: str) -> str:
    return normalize("NFC", name).casefold()


def _cells(header: Sequence[str], line: Sequence[Cell]) -> dict[str, str]:
    return dict(zip(header, (normalize("NFC", cell.text.strip()) for cell in line), strict=False))


def _add(members: dict[str, Member], number: str, member: Member, name: str) -> None:
    """Add somebody to a class; a line that is there twice is one.

    Raises:
        CannotRead: Somebody else has the id.
    """
    before = members.get(number)
    if before is not None and before.student != member.student:
        both = f"`{before.student.name}` and `{member.student.name}`"
        hints = ("give everybody an id of their own", "or delete the line of who is not in it")
        raise CannotRead(f"`{name}` has the id `{number}` more than once: {both}", hints)
    members[number] = member


class _Times:
    """Reads the column `received`, and tells what it cannot read."""

    def __init__(self, name: str, zone: tzinfo | None) -> None:
        self._name, self._zone = name, zone
        self._zoneless = False
        self._odd: list[str] = []

    def read(self, text: str) -> datetime | None:
        if not text:
            return None
        try:
            time = datetime.fromisoformat(text)
        except ValueError:
            time = None if self._zone is None else local_time(text, self._zone)
            if time is None:
                self._odd.append(f"`{text}`")
            return time
        if time.tzinfo is None and self._zone is None:
            self._zoneless = True
            return None
        return time if time.tzinfo is not None else time.replace(tzinfo=self._zone)

    def remarks(self) -> tuple[str, ...]:
        found: tuple[str, ...] = ()
        if self._zoneless:
            found = (_zoneless(self._name),)
        if self._odd:
            shown = ", ".join(self._odd[:MOST_SHOWN])
            more = f" and {len(self._odd) - MOST_SHOWN} more" if len(self._odd) > MOST_SHOWN else ""
            words = f"no times in the column `{RECEIVED}` of `{self._name}`"
            found += (f"{words}: {shown}{more}; write such as 2026-11-30T23:59:00+01:00",)
        return found


def _zoneless(name: str) -> str:
    return f"the times in `{name}` have no zone, so they do not count: give one with `--zone`"


def _plain(
    header: Sequence[str], lines: Sequence[Sequence[Cell]], file: str, zone: tzinfo | None
) -> Roster | None:
    """Return the class of a table that somebody wrote; None: it is none.

    Raises:
        CannotRead: Two have one id, or somebody has neither id nor address.
    """
    names, emails = ({*header} & {*known} for known in (PLAIN_NAMES, PLAIN_EMAILS))
    if not names or not (emails or "id" in header):
        return None
    name, email = names.pop(), emails.pop() if emails else ""
    members: dict[str, Member] = {}
    times = _Times(file, zone)
    for line in lines:
        cells = _cells(header, line)
        address = cells.get(email, "").casefold()
        number = plain_id(cells.get("id", "")) or address
        full = cells.get(name, "") or number
        if full and not number:
            hint = "everybody needs one of the two: hand-ins are found by it"
            raise CannotRead(f"`{full}` in `{file}` has neither an id nor an address", (hint,))
        if number:
            ids = {Platform.SIS.value: number} if number != address else {}
            received = times.read(cells.get(RECEIVED, ""))
            _add(members, number, Member(Student(full, address, ids=ids), received), file)
    return Roster(Platform.SIS, members, times.remarks())


def _canvas(
    header: Sequence[str], lines: Sequence[Sequence[Cell]], file: str, zone: tzinfo | None
) -> Roster:
    members: dict[str, Member] = {}
    times = _Times(file, zone)
    for line in lines:
        cells = _cells(header, line)
        number = cells.get("id", "")
        if not number.isdecimal():
            continue  # points possible, and the like
        ids = {Platform.CANVAS.value: number}
        if cells.get("sis user id"):
            ids[Platform.SIS.value] = plain_id(cells["sis user id"])
        student = Student(cells["student"], login=cells.get("sis login id", ""), ids=ids)
        _add(members, number, Member(student, times.read(cells.get(RECEIVED, ""))), file)
    return Roster(Platform.CANVAS, members, times.remarks())


def _moodle(
    header: Sequence[str], lines: Sequence[Sequence[Cell]], name: str, zone: tzinfo | None
) -> Roster:
    times = _column_of_times(header, lines)
    members: dict[str, Member] = {}
    drafts: list[str] = []
    for line in lines:
        cells = [normalize("NFC", cell.text.strip()) for cell in line]
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
        _add(members, found[1], Member(student, time), name)
    remarks: tuple[str, ...] = ()
    if times is not None and zone is None:
        remarks = (_zoneless(name),)
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
