"""Whether the files of a course name somebody now, who would get a new account by them."""

from pathlib import Path
from typing import NamedTuple

from vrts.course.course import COURSE_FILE
from vrts.course.people.sources import read_people
from vrts.live.personal.names import Names, accounts_of
from vrts.live.settings import DATABASE
from vrts.live.store.course.people import person_of
from vrts.live.store.database import read_only
from vrts.pipeline.files import CannotRead


class StillListed(NamedTuple):
    """Where the files name somebody."""

    places: tuple[str, ...] = ()  # file and line, such as `roster.csv:3`
    fault: str = ""  # why the files cannot tell; "": they can


def still_listed(course: Path, server: Path, name: str) -> StillListed:
    """Return where the files of a course name a person, by id or e-mail address.

    Args:
        course: Folder of the course.
        server: Folder of the server, which may run meanwhile.
        name: Of the person, as the server knows them.

    Raises:
        CannotRead: The database cannot be read.
    """
    try:
        with read_only(server / DATABASE) as connection:
            accounts = accounts_of(connection, Names(name))
            found = [one for account in accounts if (one := person_of(connection, account))]
    except ValueError as problem:
        raise CannotRead(f"cannot read the database: {problem}") from problem
    read = read_people(course)
    if not read.good:
        return StillListed(fault=read.words)
    keys, emails = {one.key for one in found}, {one.email for one in found} - {""}
    places = [
        COURSE_FILE if one.label is None else f"{one.label.span.source.name}:{one.label.span.line}"
        for one in read.people
        if one.key in keys or one.email in emails
    ]
    return StillListed(tuple(places))
