"""What a marking keeps to compare programs with: one zip, also the corpus of later years.

It holds programs, what their runs did, and what everybody was given, under the identifiers of the
marking. Comments in programs stay as they are, so names that students wrote there do too. It may
come from anywhere and is read without trust.
"""

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Literal, NamedTuple

import msgspec
from msgspec import Meta

from vrts.base.diagnostic import Rule, error
from vrts.base.zips import BadZip, Unpacker, packed
from vrts.marking.layout import COMPARED, Layout, write_atomically
from vrts.marking.result import Damaged, Record, decoded
from vrts.marking.similarity.features.extract import Program
from vrts.marking.submission.sketch import LARGEST as LARGEST_SKETCH
from vrts.marking.submission.sketch import SKETCH, Sketch
from vrts.marking.submission.sketch import from_bytes as sketch_from_bytes
from vrts.marking.submission.sketch import to_bytes as sketch_to_bytes
from vrts.pipeline.refused import Refused

BAD_KEPT = Rule("V775", "bad-programs-to-compare")

NAME = "programs.zip"  # in its folder in `staff`
CONTENTS = "programs.json"
SCHEMA = "vrts.programs/1"
MODE = 0o600
LARGEST_PROGRAM = 4_000_000  # bytes
LARGEST_CONTENTS = 16_000_000
LARGEST_ALL = 600_000_000  # bytes of everything, unpacked
RATIO, RATIO_FROM = 200, 64_000_000  # from so many bytes on, so many times the zip's size is a bomb
MOST_PROGRAMS = 20_000
MOST_GIVEN = 100_000  # where each student has a variant, several for each

Identifier = Annotated[str, Meta(min_length=1, max_length=400)]


class KeptProgram(Record, frozen=True):
    """A program in the zip: `programs/NUMBER.v2`, and `motion/NUMBER.json` where it ran."""

    id: Identifier
    together: Annotated[str, Meta(description="the same for who handed in together; empty: alone")]
    ran: bool


class Contents(Record, frozen=True):
    """What stands in the zip."""

    schema: Literal["vrts.programs/1"]
    title: Annotated[str, Meta(max_length=1000)]
    given: Annotated[int, Meta(ge=0, le=MOST_GIVEN)]  # files that students were given
    programs: Annotated[tuple[KeptProgram, ...], Meta(max_length=MOST_PROGRAMS)]


class Kept(NamedTuple):
    """Programs that can be compared."""

    title: str
    programs: dict[str, Program]  # by identifier
    together: dict[str, str]
    given: tuple[bytes, ...]


def place_of(layout: Layout) -> Path:
    """Return where a marking keeps its programs."""
    return layout.staff / COMPARED / NAME


def with_sketches(programs: Mapping[str, bytes], layout: Layout) -> dict[str, Program]:
    """Return programs with what their runs did, as far as marking wrote it."""
    return {name: Program(data, _sketch(layout, name)) for name, data in programs.items()}


def keep(kept: Kept, layout: Layout) -> None:
    """Write programs for later comparisons."""
    members: dict[str, bytes] = {}
    listed: list[KeptProgram] = []
    for number, (name, program) in enumerate(sorted(kept.programs.items())):
        listed.append(KeptProgram(name, kept.together.get(name, ""), program.sketch is not None))
        members[f"programs/{number}.v2"] = program.data
        if program.sketch is not None:
            members[f"motion/{number}.json"] = sketch_to_bytes(program.sketch)
    for number, data in enumerate(kept.given):
        members[f"given/{number}.v2"] = data
    contents = Contents("vrts.programs/1", kept.title[:1000], len(kept.given), tuple(listed))
    data = msgspec.json.format(msgspec.json.encode(contents), indent=1) + b"\n"
    write_atomically(place_of(layout), packed({CONTENTS: data, **members}, MODE))


def read_kept(path: Path) -> Kept:
    """Return the programs that a marking kept.

    Raises:
        Refused: It is no such zip, or is damaged.
    """
    try:
        with path.open("rb") as file:
            archive = Unpacker(file)
            total, size = sum(archive.sizes.values()), path.stat().st_size
            if total > LARGEST_ALL or (total > RATIO_FROM and total > RATIO * size):
                raise Damaged(f"it unpacks to {total / 1e6:.0f} MB")
            contents = decoded(_member(archive, CONTENTS, LARGEST_CONTENTS), Contents)
            if len({one.id for one in contents.programs}) < len(contents.programs):
                raise Damaged("it has two programs of one id")
            programs = {
                one.id: Program(
                    _member(archive, f"programs/{k}.v2", LARGEST_PROGRAM),
                    _read_sketch(archive, k) if one.ran else None,
                )
                for k, one in enumerate(contents.programs)
            }
            given = tuple(
                _member(archive, f"given/{k}.v2", LARGEST_PROGRAM) for k in range(contents.given)
            )
    except (OSError, BadZip, Damaged) as problem:
        why = str(problem) if isinstance(problem, Damaged) else "it cannot be read"
        headline = f"`{path}` holds no programs to compare: {why[:200]}"
        remedy = "mark that class again, or name the folder of its programs"
        raise Refused((error(BAD_KEPT, headline, help=(remedy,)),)) from problem
    together = {one.id: one.together for one in contents.programs}
    return Kept(contents.title, programs, together, given)


def is_kept(path: Path) -> bool:
    """Return whether a file is such a zip, by its table of contents."""
    try:
        with path.open("rb") as file:
            return CONTENTS in Unpacker(file).sizes
    except (OSError, BadZip):
        return False


def _member(archive: Unpacker, name: str, most: int) -> bytes:
    if archive.sizes.get(name, most + 1) > most:
        raise Damaged(f"`{name}` is missing or too large")
    return archive.read(name)


def _read_sketch(archive: Unpacker, number: int) -> Sketch:
    return sketch_from_bytes(_member(archive, f"motion/{number}.json", LARGEST_SKETCH))


def _sketch(layout: Layout, name: str) -> Sketch | None:
    """Return what a run did; None: it did not run, or an earlier vrts marked it."""
    try:
        return sketch_from_bytes((layout.grader(name) / SKETCH).read_bytes())
    except (OSError, Damaged):
        return None
