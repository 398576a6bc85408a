"""All that a course keeps of a person, as one zip: the server's, and the files of the course."""

import zipfile
from pathlib import Path
from typing import IO, Final, NamedTuple

from vrts.course.personal.files import files_of, whose
from vrts.live.personal.export import Exported, export
from vrts.live.settings import DATABASE
from vrts.live.store.database import read_only
from vrts.pipeline.files import CannotRead

README: Final = """\
What the course keeps of {name} beside that
============================================

course/handed-in/   every program that was handed in, by assignment and time
course/published/   marks and comments that were published
course/reports/     pages about programs that nobody else handed in
"""


class HandedOut(NamedTuple):
    """What was handed out."""

    server: Exported
    files: int  # of the course


def hand_out(course: Path, server: Path, name: str, target: IO[bytes]) -> HandedOut:
    """Write all that is kept of a person as a zip; the server may run meanwhile.

    Args:
        course: Folder of the course.
        server: Folder of the server.
        name: Of the person.
        target: A file that is open to write and read.

    Raises:
        CannotRead: The database cannot be read.
    """
    exported = export(server, name, target)
    if not exported.accounts:
        return HandedOut(exported, 0)
    try:
        with read_only(server / DATABASE) as connection:
            who = whose(connection, name)
    except ValueError as problem:
        raise CannotRead(f"cannot read the database: {problem}") from problem
    count = 0
    with zipfile.ZipFile(target, "a", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("course/README.txt", README.format(name=name))
        for file in files_of(course, server, who):
            archive.write(file.path, f"course/{file.name}")
            count += 1
    return HandedOut(exported, count)
