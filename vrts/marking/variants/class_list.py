"""Who is in a class, and what each variant is drawn by.

A variant is drawn by the student's address where the list has one, else by the id on the platform:
both are the same in every list of the class, while names change.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from vrts.base.diagnostic import Rule, error
from vrts.marking.intake.row import Platform, Row, Student
from vrts.marking.intake.tables.roster import Roster
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

TWICE = Rule("V869", "twice-in-the-class")


class Member(NamedTuple):
    """Somebody in the class."""

    number: str  # id on the platform
    student: Student
    drawn_by: str  # what the variant is drawn by


class ClassList(NamedTuple):
    """A class, and how a hand-in is matched with somebody in it."""

    platform: Platform
    members: tuple[Member, ...]

    def member_of(self, row: Row) -> Member | None:
        """Return whose hand-in a row is; None where nobody's, or more than one may be meant.

        The id of the platform decides. Where a row has none, its name in the download and its
        address do, if they are an id, an address or a login of one in the class.
        """
        student = row.student
        return self.member(row.identifier, student.email, student.login, student.ids)

    def member(
        self, identifier: str, email: str, login: str, ids: Mapping[str, str]
    ) -> Member | None:
        """Return who is meant, as `member_of`."""
        number = ids.get(self.platform.value, "")
        if number:
            return next((one for one in self.members if one.number == number), None)
        called = {identifier, email, login, *ids.values()}
        asked = {text.casefold() for text in called if text}
        found = [one for one in self.members if asked & set(_names(one))]
        return found[0] if len(found) == 1 else None


def class_list(roster: Roster, name: str) -> ClassList:
    """Return a class of a list that a platform has exported.

    Raises:
        CannotRead: Nobody is in it.
        Refused: Two in it cannot be told apart.
    """
    members = tuple(
        Member(number, one.student, _drawn_by(roster.platform, number, one.student))
        for number, one in roster.members.items()
    )
    if not members:
        raise CannotRead(f"nobody is in `{name}`")
    several = [text for text, count in Counter(m.drawn_by for m in members).items() if count > 1]
    if several:
        headline = f"`{name}` has `{several[0]}` more than once"
        remedy = "give everybody an address of their own, or none at all"
        raise Refused((error(TWICE, headline, help=(remedy,)),))
    return ClassList(roster.platform, members)


def _drawn_by(platform: Platform, number: str, student: Student) -> str:
    return student.email.strip().casefold() or f"{platform.value} {number}"


def _names(member: Member) -> Iterator[str]:
    student = member.student
    for text in (member.number, student.email, student.login, *student.ids.values()):
        if text:
            yield text.casefold()


def shown_names(members: Iterable[Member], most: int = 3) -> str:
    """Return some members in words: "`Ada Byron`, `Kurt Weill` and 2 more"."""
    names = [f"`{one.student.name or one.number}`" for one in members]
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more
