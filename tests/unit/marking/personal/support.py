"""A class with all that may be kept of a student, and the files of a folder, zips unpacked."""

import io
import zipfile
from collections.abc import Iterator
from pathlib import Path

from click.testing import CliRunner, Result

from tests.unit.marking.by_hand.support import AT, written
from vrts.cli.main import vrts
from vrts.marking.appeals.written import read_written
from vrts.marking.by_hand.decisions.records import (
    ChangeMark,
    Comment,
    Decide,
    Finish,
    Give,
    Item,
    Undo,
)
from vrts.marking.layout import Layout
from vrts.marking.renewing.renewed import renewed
from vrts.pipeline.files import CHECKOUT

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
GOOD = (EXAMPLE / "solution.v2").read_text()
BAD = (EXAMPLE / "submissions" / "hits-base.v2").read_text()
WORDS = "my very own words zq9"
MINE = "Querulin-Zwackelmann-4711"


def call(*words: object) -> Result:
    """Call `vrts`."""
    return CliRunner().invoke(vrts, [str(word) for word in words])


def contents(folder: Path) -> Iterator[tuple[str, bytes]]:
    """Yield the names and bytes of all files, also of what is in zips."""
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            yield from unpacked(path.relative_to(folder).as_posix(), path.read_bytes())


def unpacked(name: str, data: bytes) -> Iterator[tuple[str, bytes]]:
    """Yield a file, and what is in it if it is a zip."""
    yield name, data
    if data.startswith(b"PK\x03\x04"):
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            for inside in archive.namelist():
                yield from unpacked(f"{name}!{inside}", archive.read(inside))


def download(folder: Path) -> Path:
    """Write a download as Moodle packs it."""
    programs = {
        "Anna Ady_1": f"; {WORDS[:7]} of anna\n{GOOD}",
        "Ben Otto_2": BAD,
        "Querulin Zwackelmann_4711": f"; {WORDS}\n{GOOD}",
    }
    for name, text in programs.items():
        place = folder / f"{name}_assignsubmission_file_"
        place.mkdir(parents=True)
        (place / "pick.v2").write_text(text)
    return folder


def decided(layout: Layout, ids: dict[str, str]) -> None:
    """Write what two graders decided, about one, about several, and about decisions."""
    mine, anna, ben = ids["querulin"], ids["anna"], ids["ben"]
    huber = written(
        "huber",
        Comment(1, AT, mine, "Querulin, look at the base"),
        Item(2, AT, "late-grip", "grips late", "-1/2"),
        Give(3, AT, "late-grip", (anna, mine), programs={mine: "", anna: ""}),
        ChangeMark(4, AT, (mine,), "Zwackelmann was ill", "1"),
        Comment(5, AT, ben, "well done"),
        Undo(6, AT, ("huber:4", "huber:5"), "both too early"),
    )
    lang = written(
        "lang",
        Finish(1, AT, mine, "8"),
        ChangeMark(2, AT, (mine,), "again", "2"),
        Undo(3, AT, ("lang:2",)),
        Undo(4, AT, ("lang:3",)),
        Decide(5, AT, "lang:2", ("huber:4",), "as agreed"),
        Comment(6, AT, anna, "nice"),
    )
    layout.decisions.mkdir(exist_ok=True)
    (layout.decisions / "huber.jsonl").write_bytes(huber)
    (layout.decisions / "lang.jsonl").write_bytes(lang)
    change = (
        '[[change]]\nstudent = "{}"\ndelta = 1\nreason = "{}"\nwho = "jh"\ndate = "2026-11-20"\n'
    )
    layout.overrides.write_text(
        "# ours\r\n\r\n"
        + change.format(anna, "table")
        + f"\n# about {mine}\n"
        + change.format(mine, "Querulin was ill")
        + "\n# and ben\n"
        + change.format(ben, "lamp"),
        newline="",
    )
    renewed(layout)


def ids_of(folder: Path) -> dict[str, str]:
    """Return ids by first name."""
    rows = read_written(folder).rows.rows
    return {row.student.name.split()[0].lower(): row.id for row in rows}
