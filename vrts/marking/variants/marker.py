"""Marks each student by the student's own variant: as many markers as there are variants.

Each variant is an ordinary packed task in a folder, so evidence, other machines and processes that
are started anew mark by it without knowing of variants.
"""

from collections.abc import Iterable, Mapping
from copy import copy
from pathlib import Path

import msgspec

from vrts.marking.layout import Layout
from vrts.marking.result import Result
from vrts.marking.submission.marker import Marker, Marks
from vrts.marking.submission.one import Order, Wanted
from vrts.marking.submission.setting import Place

PRIVATE = 0o600


class VariantsMarker(Marker):
    """Marks programs of students each of whom has a variant of one task."""

    def __init__(
        self,
        place: Place,
        wanted: Wanted,
        variants: Iterable[Place] = (),
        tags: Mapping[str, str] | None = None,
    ) -> None:
        """Read the task as it is written.

        Args:
            place: Of the task.
            wanted: What is to be made of every program.
            variants: Where its variants are packed, each with its tag.
            tags: By identifier of a student: which is the student's.
        """
        super().__init__(place, wanted)
        self._plain = Marker(place, wanted)
        self._made: dict[str, Marker] = {}
        self.places: dict[str, Place] = {one.variant or "": one for one in variants}  # by tag
        self.tags = dict(tags or {})  # by identifier of a student; none: not in the class

    def of(self, identifier: str) -> Marker:
        """Return what marks the program of a student."""
        return self.by(self.tags.get(identifier, ""))

    def by(self, tag: str) -> Marker:
        """Return what marks by a variant; by the task as it is written where there is no such."""
        if tag not in self.places:
            found = self._plain
        else:
            if tag not in self._made:
                self._made[tag] = Marker(self.places[tag], self.wanted)
            found = self._made[tag]
            found.kept = self._plain.kept
        if found.wanted is not self.wanted:  # this is a copy that wants less
            found = copy(found)
            found.wanted = self.wanted
        return found

    def work(self, order: Order, folder: Path) -> bytes:
        """Mark a program by its student's variant."""
        return self.of(order.whose or order.identifier).work(order, folder)

    def command(self, order: Order, folder: Path) -> tuple[list[str], bytes]:
        """Return the same as a command."""
        return self.of(order.whose or order.identifier).command(order, folder)

    def warm_up(self) -> None:
        """Load what all share."""
        self._plain.warm_up()

    def rest(self) -> None:
        """Give up what was kept for all."""
        self._plain.rest()

    def lost(self, order: Order, sentence: str) -> Marks:
        """Return the results of an order whose process was ended."""
        return self.of(order.whose or order.identifier).lost(order, sentence)


def variant_place(place: Place, layout: Layout, result: Result) -> Place | None:
    """Return where the variant is by which a result was made; None: it is of a task without.

    Args:
        place: Of the task, with what is laid over it.
        layout: Of the results.
        result: For those who mark.
    """
    tag = "" if result.variant is None else result.variant.tag
    path = layout.variants / f"{tag}.zip"
    if not tag or not path.is_file():
        return None
    return msgspec.structs.replace(place, task=str(path), variant=tag)


def write_variants(packed: Mapping[str, bytes], layout: Layout) -> None:
    """Write packed variants where results of them are; those of other tasks go."""
    for other in layout.variants.glob("*.zip"):
        if other.stem not in packed:
            other.unlink()
    for tag, data in packed.items():
        layout.variants.mkdir(parents=True, exist_ok=True)
        path = layout.variants / f"{tag}.zip"
        path.touch(PRIVATE)  # hidden checks are in it
        path.write_bytes(data)
