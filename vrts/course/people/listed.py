"""Everybody whom the files of a course name, each once."""

from collections.abc import Iterable
from typing import Final, NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.course.course import Course, Rank, Team
from vrts.live.people.naming import person_name

CLASS_LIST: Final = Rule("V914", "class-list")
MOST: Final = 5000  # people of a course


class Listed(NamedTuple):
    """Somebody whom a file names."""

    key: str  # platform and id, else e-mail address: what stays when a name changes
    name: str
    email: str  # in lower case; empty: the list does not tell
    ids: dict[str, str]  # on platforms
    rank: Rank = "student"
    team: str = ""
    rooms: tuple[str, ...] = ()  # names of those that an assistant leads; empty: all
    label: Label | None = None  # where it says so


def everybody(
    course: Course, students: Iterable[Listed]
) -> tuple[tuple[Listed, ...], tuple[Diagnostic, ...]]:
    """Return staff and students, and what is wrong with them all together.

    Who teaches and is on the list of the class as well, teaches.
    """
    found: list[Listed] = []
    faults: list[Diagnostic] = []
    keys: dict[str, Listed] = {}
    emails: dict[str, Listed] = {}
    for one in course.staff:
        staff = Listed(one.email, one.name, one.email, {}, one.rank, rooms=one.rooms)
        _add(staff, found, faults, keys, emails)
    taught = {one.email for one in found}
    for student in students:
        if student.email not in taught or not student.email:
            team = student.team or _team(student, course.teams)
            _add(student._replace(team=team), found, faults, keys, emails)
    if len(found) > MOST:
        faults.append(error(CLASS_LIST, f"a course has at most {MOST} people"))
    return tuple(found), tuple(faults)


def _add(
    one: Listed,
    found: list[Listed],
    faults: list[Diagnostic],
    keys: dict[str, Listed],
    emails: dict[str, Listed],
) -> None:
    other = keys.get(one.key) or (emails.get(one.email) if one.email else None)
    if not person_name(one.name):
        faults.append(error(CLASS_LIST, f"`{one.name}` is no name that can be shown", one.label))
    elif other is not None:
        what = "the same e-mail address" if one.key != other.key else f"the same key, `{one.key}`"
        text = f"`{one.name}` and `{other.name}` have {what}"
        faults.append(error(CLASS_LIST, text, one.label, help=("leave one of them",)))
    else:
        keys[one.key] = one
        if one.email:
            emails[one.email] = one
        found.append(one)


def _team(student: Listed, teams: tuple[Team, ...]) -> str:
    """Return the team that names somebody by address, name or id."""
    known = {student.email, student.name.casefold(), *student.ids.values()} - {""}
    return next((team.name for team in teams if not known.isdisjoint(team.members)), "")
