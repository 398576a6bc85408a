"""The variants of a class that is marked: whose hand-in is by which, packed in a folder."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from vrts.assignments.pack import staff_zip
from vrts.assignments.task_folder import SOLUTION
from vrts.assignments.variants.key import key_of, place_of_key
from vrts.assignments.variants.of_task import VariedTask, load_varied
from vrts.check.variants.drawn import Variant
from vrts.marking.intake.row import Row
from vrts.marking.intake.tables.roster import read_roster
from vrts.marking.layout import Layout
from vrts.marking.row import Row as Marked
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.variants.class_list import ClassList, Member, class_list
from vrts.marking.variants.handed import (
    Students,
    changed_since,
    check_some_left,
    read_handed,
    record_gone,
    variants_of,
)
from vrts.marking.variants.marker import VariantsMarker
from vrts.pipeline.files import STAFF, CannotRead, read_bytes

PRIVATE = 0o600


class MarkerOfClass(VariantsMarker):
    """Marks a class, each by an own variant: the list of the class and the key tell which."""

    def __init__(
        self,
        place: Place,
        wanted: Wanted,
        members: ClassList,
        key: Path,
        handed: bool = True,
    ) -> None:
        """Read the task, and find everybody's variant: as handed out, else as drawn.

        Args:
            place: Of the task.
            wanted: What is to be made of every program.
            members: Who is in the class.
            key: File of the key; beside it stands what was handed out.
            handed: Whether to go by that.

        Raises:
            CannotRead: A file is not there.
            Refused: Task or `[variants]` have errors, or are not those of what was handed out.
        """
        super().__init__(place, wanted)
        secret = key_of(key)
        self.varied: VariedTask = load_varied(Path(place.task)).with_key(secret)
        self.members = members
        assignment = self.varied.variants.assignment
        was = read_handed(key, secret, assignment) if handed else Students()
        gone = record_gone(key, assignment, was) if handed else ()
        other = changed_since(key, secret, self.varied) if handed else ()
        self.findings = (*gone, *other)
        given = variants_of(self.varied, members, secret, was, lost=bool(gone))
        check_some_left(given, key)
        self._doubted = given.doubts
        self._whose = {number: variant.tag for number, variant in given.variants.items()}
        self.doubtful: dict[str, str] = {}  # by identifier: why it may be another's variant
        self.variants: dict[str, Variant] = {}  # of everybody in the class, by tag
        self.owners: dict[str, list[Member]] = {}  # by tag
        for member in members.members:
            variant = given.variants[member.number]
            self.variants[variant.tag] = variant
            self.owners.setdefault(variant.tag, []).append(member)

    def assign(self, rows: Sequence[Row], folder: Path, *, some: bool = False) -> None:
        """Say whose hand-in each row is, and pack the variants of the class.

        Args:
            rows: Of the intake.
            folder: For the variants.
            some: Whether these are some of the class: then what the marks of others were given by
                stays as it is. Else what is there of other tasks goes.
        """
        for row in rows:
            member = self.members.member_of(row)
            if member is not None:
                self.tags[row.identifier] = self._whose[member.number]
                if member.number in self._doubted:
                    self.doubtful[row.identifier] = self._doubted[member.number]
        asked = set(self.tags.values())
        folder.mkdir(parents=True, exist_ok=True)
        for tag, variant in self.variants.items():
            path = folder / f"{tag}.zip"
            data = packed_variant(self.varied, variant)
            if not path.is_file() or path.read_bytes() != data:
                if some and tag not in asked and path.exists():
                    continue
                path.touch(PRIVATE)  # hidden checks are in it
                path.write_bytes(data)
            self.places[tag] = Place(str(path), lab=self.place.lab, variant=tag)
        for other in () if some else folder.glob("*.zip"):
            if other.stem not in self.variants:
                other.unlink()

    def is_as_before(self, row: Marked, layout: Layout) -> bool:
        """Return whether a mark was given by the variant that its student has, as it still is."""
        result = row.result
        tag = "" if result.variant is None else result.variant.tag
        student = row.student
        found = self.members.member(row.id, student.email, student.login, student.ids)
        if found is not None and self._whose[found.number] != tag:
            return False
        if not tag:
            assert self.whole.task is not None
            return result.task.sha256 == self.whole.task.digest
        path = layout.variants / f"{tag}.zip"
        variant = self.variants.get(tag)
        return (
            variant is not None
            and path.is_file()
            and path.read_bytes() == packed_variant(self.varied, variant)
        )

    def renamed(self, names: Mapping[str, str]) -> None:
        """Take other identifiers for the students, by those of the intake."""
        self.tags = {names[name]: tag for name, tag in self.tags.items() if name in names}
        self.doubtful = {names[name]: t for name, t in self.doubtful.items() if name in names}


def packed_variant(varied: VariedTask, variant: Variant) -> bytes:
    """Return a variant with its hidden part as a zip, without the solution."""
    files = varied.of(variant.combination)
    staff = {name: d for name, d in files.staff.items() if name != f"{STAFF}/{SOLUTION}"}
    return staff_zip(files._replace(staff=staff), varied.base.hidden)


def marker_for(place: Place, wanted: Wanted, roster: Path | None, key: Path | None) -> Marker:
    """Return what marks a class by a task; where that has variants, each student by the own one.

    Args:
        place: Of the task.
        wanted: What is to be made of every program.
        roster: The list of the class; None: there is none.
        key: File of the key of the variants; None: that beside the task.

    Raises:
        CannotRead: A file is not there, or is needed for variants and was not named.
        Refused: Task, list or key have errors.
    """
    plain = Marker(place, wanted)
    assert plain.whole.task is not None
    if plain.whole.task.variants is None:
        if key is not None:
            raise CannotRead(f"`--key` is for variants, and `{place.task}` has none")
        return plain
    if roster is None:
        raise CannotRead(
            "each student has a variant of this task, and nothing says who is who",
            ("name the list of the class with `--roster`, as for `vrts task variants`",),
        )
    if place.scene is not None or place.scenario is not None:
        raise CannotRead("a task with variants is marked in its own scene and scenario")
    members = class_list(read_roster(read_bytes(roster), roster.name, None), roster.name)
    return MarkerOfClass(place, wanted, members, key or place_of_key(Path(place.task)))
