"""The variants of a class that is marked: whose hand-in is by which, packed in a folder."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from vrts.assignments.pack import staff_zip
from vrts.assignments.task_folder import SOLUTION
from vrts.assignments.variants.key import key_of, place_of_key
from vrts.assignments.variants.of_task import VariedTask, load_varied
from vrts.check.variants.drawn import Variant, drawn
from vrts.marking.intake.row import Row
from vrts.marking.intake.tables.roster import read_roster
from vrts.marking.layout import Layout
from vrts.marking.result import Result
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.variants.class_list import ClassList, Member, class_list
from vrts.marking.variants.marker import VariantsMarker
from vrts.pipeline.files import STAFF, CannotRead, read_bytes

PRIVATE = 0o600


class MarkerOfClass(VariantsMarker):
    """Marks a class, each by an own variant: the list of the class and the key tell which."""

    def __init__(self, place: Place, wanted: Wanted, members: ClassList, key: bytes) -> None:
        """Read the task, and draw everybody's variant.

        Raises:
            CannotRead: A file is not there.
            Refused: Task or `[variants]` have errors.
        """
        super().__init__(place, wanted)
        self.varied: VariedTask = load_varied(Path(place.task))
        self.members = members
        self.variants: dict[str, Variant] = {}  # of everybody in the class, by tag
        self.owners: dict[str, list[Member]] = {}  # by tag
        for member in members.members:
            variant = drawn(self.varied.variants, key, member.drawn_by)
            self.variants[variant.tag] = variant
            self.owners.setdefault(variant.tag, []).append(member)

    def assign(self, rows: Sequence[Row], folder: Path) -> None:
        """Say whose hand-in each row is, and pack the variants of the class.

        Args:
            rows: Of the intake.
            folder: For the variants; what is there of other tasks goes.
        """
        whose = {m.number: tag for tag, members in self.owners.items() for m in members}
        for row in rows:
            member = self.members.member_of(row)
            if member is not None:
                self.tags[row.identifier] = whose[member.number]
        folder.mkdir(parents=True, exist_ok=True)
        for tag, variant in self.variants.items():
            path = folder / f"{tag}.zip"
            data = packed_variant(self.varied, variant)
            if not path.is_file() or path.read_bytes() != data:
                path.touch(PRIVATE)  # hidden checks are in it
                path.write_bytes(data)
            self.places[tag] = Place(str(path), lab=self.place.lab, variant=tag)
        for other in folder.glob("*.zip"):
            if other.stem not in self.variants:
                other.unlink()

    def is_as_before(self, result: Result, layout: Layout) -> bool:
        """Return whether a result was made by a variant as it still is."""
        tag = "" if result.variant is None else result.variant.tag
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
    secret = key_of(key or place_of_key(Path(place.task)))
    return MarkerOfClass(place, wanted, members, secret)
