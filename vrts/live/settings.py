"""What a server is told when it is started."""

import re
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Final, NamedTuple

from vrts.base.safe_names import safe

DATABASE: Final = "live.sqlite"  # in the server's folder
SESSIONS: Final = "sessions"  # folder for the sessions' own files
VARIANTS: Final = "variants"  # tasks that are another one for each student, each by its tag
EDITING: Final = "editing"  # empty folder in which language servers begin
REHEARSING: Final = "rehearsing"  # empty folder in which rehearsals begin
HISTORY_QUOTA: Final = 64_000_000  # bytes of a session's file of what is older than ten minutes
LOG_QUOTA: Final = 256_000_000  # bytes of the log of a session
_TAG: Final = re.compile(r"[a-z]{4}-[a-z]{4}")


class Place(NamedTuple):
    """A scene of the set."""

    id: str  # what it is called in messages
    scene: str  # name of the library, or path; empty: the task's
    task: str  # path of a task file; empty without one
    lab: str = ""  # path of a lab file


@dataclass(frozen=True, slots=True)
class Settings:
    """Of one server."""

    folder: Path  # what it keeps: database, files of sessions
    places: tuple[Place, ...]  # the set of scenes, at least one
    names: tuple[str, ...] = ()  # it answers to, besides localhost and addresses
    secure: bool = False  # browsers reach it by https
    port: int = 8000  # part of the cookie's name: browsers keep cookies of all ports together
    alone: bool = False  # one user: the control right comes with entering
    students_reset: bool = False  # operators may reset and rewind
    idle_s: float = 120.0  # of new rooms
    turn_s: float = 0.0
    private_rooms: int = 8  # at once, one a person
    history_quota: int = HISTORY_QUOTA
    log_quota: int = LOG_QUOTA
    log_key: Path | None = None  # file with the key of the logs; None: the usual one
    recorded: Callable[[str], None] | None = None  # told the row of every location recorded

    @property
    def cookie(self) -> str:
        """The name of the cookie."""
        return f"vrts_{self.port}"

    def place(self, id_: str) -> Place | None:
        """Return a scene of the set."""
        return next((place for place in self.places if place.id == id_), None)


def variant_task(server: Path, assignment: str, tag: str, task: Path) -> Path:
    """Return where the file of a variant's task is; a course writes it before a room is opened.

    Args:
        server: Folder of the server.
        assignment: Id of the assignment: that of the place, too.
        tag: Of the variant.
        task: File of the task as it is written.

    Raises:
        ValueError: That is no tag.
    """
    if not _TAG.fullmatch(tag):
        raise ValueError(f"`{tag}` is no tag of a variant")
    return server / VARIANTS / assignment / tag / safe(task.parent.name) / task.name


def own_place(server: Path, place: Place, tag: str) -> Place:
    """Return a place of the set in a variant; as it is written where the tag is empty."""
    if not tag:
        return place
    return place._replace(task=str(variant_task(server, place.id, tag, Path(place.task))))
