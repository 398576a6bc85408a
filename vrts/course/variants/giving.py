"""Gives somebody a variant of a task: what was handed out, else a draw, written down and sealed.

The key and its record are those of `vrts task variants`, so `vrts grade` marks by them. A team has
a variant of its own in the record, and so has each of its members.
"""

import os
import secrets
import shutil
from pathlib import Path
from typing import Final, NamedTuple

from vrts.assignments.variants.handed_out import Pictures, handed_out, pictures_of
from vrts.assignments.variants.key import (
    BAD_KEY,
    key_made,
    note_handed,
    place_of_handed,
    place_of_key,
)
from vrts.assignments.variants.of_task import VariedTask, load_varied
from vrts.base.diagnostic import Rule
from vrts.base.safe_names import safe
from vrts.base.zips import Unpacker
from vrts.check.variants.drawn import Variant
from vrts.course.variants.asked import Called, GiveIt, Given
from vrts.course.variants.task_stamp import task_stamp
from vrts.marking.intake.tables.roster import read_roster
from vrts.marking.variants.class_list import ClassList, Member, class_list
from vrts.marking.variants.handed import (
    NO_RECORD,
    handed_to,
    name_of,
    read_handed,
    record_gone,
    sealed_with,
    variant_of,
)
from vrts.pipeline.files import CannotRead, read_bytes
from vrts.pipeline.refused import Refused

KEPT: Final = 2  # tasks
PRIVATE: Final = 0o600
CHANGED: Final = "its variants were changed after they were handed out: tell your teacher"
NO_KEY: Final = "its key, or the record of what was handed out, is not in order: tell your teacher"
NOT_SOUND: Final = "its variants have a fault that only your teacher can mend"
NOBODY: Final = "the list of the class does not tell who you are: tell your teacher"
NOT_KEPT: Final = "your variant of the task could not be written: tell your teacher"
_OF_KEY: Final[tuple[Rule, ...]] = (BAD_KEY, NO_RECORD)


class _Read(NamedTuple):
    """A task with variants, as it was read."""

    stamp: int
    varied: VariedTask
    pictures: Pictures


class Giver:
    """Gives variants, and keeps the tasks that were asked of last."""

    def __init__(self) -> None:
        """Begin with none."""
        self._known: dict[Path, _Read] = {}

    def give(self, asked: GiveIt) -> Given:
        """Return somebody's variant, and where it lies; or why there is none."""
        try:
            return self._give(asked)
        except Refused as refused:
            of_key = any(one.rule in _OF_KEY for one in refused.diagnostics)
            return Given(problem=NO_KEY if of_key else NOT_SOUND)
        except CannotRead:
            return Given(problem=NOT_SOUND)
        except OSError:
            return Given(problem=NOT_KEPT)

    def _give(self, asked: GiveIt) -> Given:
        task = Path(asked.task)
        read = self._read(task.parent)
        place = place_of_key(task)
        secret, _ = key_made(place)
        varied = read.varied.with_key(secret)
        assignment = varied.variants.assignment
        was = read_handed(place, secret, assignment)
        lost = record_gone(place, assignment, was)
        if lost:  # another draw may be another variant than they have
            raise Refused(lost)
        roster = Path(asked.roster)
        members = class_list(read_roster(read_bytes(roster), roster.name, None), roster.name)
        names, drawn_by = _names(asked, members)
        if not names:
            return Given(problem=NOBODY)
        before = was.get(names[0])
        variant = varied.drawn(secret, drawn_by) if before is None else None
        if before is not None:
            variant = variant_of(varied.variants, before)
        if variant is None:
            return Given(problem=CHANGED)
        handed = dict.fromkeys(names, handed_to(varied.variants, variant))
        folder = Path(asked.folder) / variant.tag
        found = self._unpacked(read, varied, variant, folder, task)
        if any(was.get(name) != one for name, one in handed.items()):
            _write_private(place_of_handed(place), sealed_with(place, secret, assignment, handed))
            note_handed(place, assignment)
        return Given(variant.tag, str(found))

    def _read(self, folder: Path) -> _Read:
        stamp = task_stamp(folder)
        known = self._known.get(folder)
        if known is None or known.stamp != stamp:
            while len(self._known) >= KEPT:
                del self._known[next(iter(self._known))]
            varied = load_varied(folder)
            known = self._known[folder] = _Read(stamp, varied, pictures_of(varied))
        return known

    def _unpacked(
        self, read: _Read, varied: VariedTask, variant: Variant, folder: Path, task: Path
    ) -> Path:
        """Return the file of a variant's task; written again where the task has changed since."""
        name = safe(task.parent.name)
        found, noted = folder / name / task.name, folder / f"of-{read.stamp:x}"
        if found.is_file() and noted.is_file():
            return found
        data = handed_out(varied, variant, read.pictures).data
        draft = folder.with_name(f".{secrets.token_hex(6)}")
        _unpack(data, draft / name)
        (draft / noted.name).touch()
        if folder.exists():
            old = folder.with_name(f".{secrets.token_hex(6)}")
            folder.rename(old)
            draft.rename(folder)
            shutil.rmtree(old, ignore_errors=True)
        else:
            draft.rename(folder)
        return found


def _names(asked: GiveIt, members: ClassList) -> tuple[list[str], str]:
    """Return by what the record knows whose variant it is, theirs first, and what it is drawn by.

    Who is not in the list of the class any more has nothing in the record.
    """
    found = [one for called in asked.people if (one := _member(called, members)) is not None]
    names = [name_of(members.platform, one) for one in found]
    if not found:
        return [], ""
    if asked.team:
        return [f"team {asked.team}", *names], f"team {asked.team}"
    return names, found[0].drawn_by


def _member(called: Called, members: ClassList) -> Member | None:
    return members.member("", called.email, "", called.ids)


def _unpack(data: bytes, folder: Path) -> None:
    archive = Unpacker(data)
    for name in archive.sizes:
        inside = name.split("/", 1)[1]
        if inside and not inside.endswith("/"):
            path = folder / inside
            path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
            path.write_bytes(archive.read(name))


def _write_private(path: Path, data: bytes) -> None:
    """Write a file for its owner alone, so that it is there whole or not at all."""
    draft = path.with_name(f"{path.name}.part")
    with open(os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, PRIVATE), "wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    draft.replace(path)
