"""What a student handed in, found again in the download: exactly those bytes, or none."""

from collections.abc import Sequence
from pathlib import Path

from vrts.base.diagnostic import Rule, error
from vrts.check.task.manifest import sha256
from vrts.marking.about import About
from vrts.marking.appeals.written import Written
from vrts.marking.intake.candidate import data_of
from vrts.marking.intake.tables.table_text import read_text, table, table_bytes
from vrts.marking.intake.tree.opening import Unreadable, open_place
from vrts.marking.privacy.pseudonyms import read_names
from vrts.marking.row import Row
from vrts.marking.submission.submissions import of_example
from vrts.pipeline.files import CannotRead, read_bytes
from vrts.pipeline.refused import Refused

OTHER_PROGRAM = Rule("V762", "program-changed-since")


def handed_in(written: Written, row: Row, download: Path | None) -> bytes | None:
    """Return the file that a row is about, as it was handed in; None where there is none.

    Args:
        written: The marking.
        row: Of the student.
        download: Where the download is now; None: where it was.

    Raises:
        CannotRead: The download is not there.
        Refused: It holds another program than the one that was marked.
    """
    file = file_of(written, row)
    about = row.result.program
    if file is None:
        if about is not None:
            raise _other("the marking does not say which file it was")
        return None
    try:
        with open_place(_place(written.about, download)) as tree:
            data = data_of(tree, file)
    except Unreadable as flaw:
        if about is None:
            return None
        raise _other(f"the file {flaw}") from flaw
    except CannotRead as problem:
        hint = "say with `--submissions` where the download is now"
        raise CannotRead(problem.message, (*problem.hints, hint)) from problem
    if about is not None and sha256(data) != about.sha256:
        raise _other("the file has other bytes")
    return data


def file_of(written: Written, row: Row) -> str | None:
    """Return the name of a student's file in the download."""
    names = read_names(written.layout)
    if row.id in names:
        return names[row.id].get("file") or None
    return row.handed_in.file or None


def intake_row(written: Written, row: Row) -> bytes | None:
    """Return the line of `intake.csv` about a student, under its header; None without one."""
    path = written.layout.intake
    if not path.is_file():
        return None
    lines = [
        [cell.text for cell in line]
        for line in table(read_text(read_bytes(path), path.name), ("id", "file", "problem"))
    ]
    heads = [text.strip().casefold() for text in lines[0]] if lines else []
    if "id" not in heads:
        return None
    at = heads.index("id")
    mine = [line for line in lines[1:] if len(line) > at and line[at].strip() == row.id]
    if not mine:
        return None
    return table_bytes((lines[0], mine[0]))


def _place(about: About, download: Path | None) -> Path | Sequence[Path]:
    """Return what was marked, as marking was told it."""
    if download is not None:
        return download
    paths = [Path(text) for text in about.submissions]
    if not paths:
        return of_example(Path(about.place.task).parent)
    alone = len(paths) == 1 and (paths[0].is_dir() or paths[0].suffix.lower() == ".zip")
    return paths[0] if alone else paths


def _other(why: str) -> Refused:
    headline = "the program that was marked is not in the download any more"
    remedy = "say with `--submissions` where the download is that was marked, or mark again"
    return Refused((error(OTHER_PROGRAM, headline, notes=(why,), help=(remedy,)),))
