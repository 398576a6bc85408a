"""Reads intake.csv back, as the teacher left it, and obeys it."""

from collections.abc import Sequence
from datetime import datetime
from difflib import get_close_matches
from typing import NamedTuple
from unicodedata import normalize

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.safe_names import safe
from vrts.base.source import Span
from vrts.base.toml.problems import Problems
from vrts.marking.intake.candidate import inspect
from vrts.marking.intake.row import Attempt, Intake, Kind, Platform, Problem, Row, Student
from vrts.marking.intake.tables.intake_table import COLUMNS, COUNTS, NO, UNKNOWN_TIME, YES
from vrts.marking.intake.tables.table_text import Cell, read_text, table
from vrts.marking.intake.tree.content import is_zip
from vrts.marking.intake.tree.file_names import same_name
from vrts.marking.intake.tree.opening import Tree

INTAKE_TABLE = Rule("V700", "intake-table")
INTAKE_ID = Rule("V701", "intake-id")
INTAKE_FILE = Rule("V702", "intake-file")
NOTHING_CHOSEN = Rule("V703", "nothing-chosen")
INTAKE_PROBLEM = Rule("V704", "intake-problem")
INTAKE_VALUE = Rule("V705", "intake-value")
NOT_IN_TABLE = Rule("V706", "not-in-table")
OTHER_DOWNLOAD = Rule("V790", "table-of-another-download")

REQUIRED = ("id", "file", "problem")
LARGEST = 16_000_000  # bytes of a table
SHOWN = 5  # identifiers named in a note


class EditedTable(NamedTuple):
    """What a table says."""

    rows: tuple[Row, ...] | None  # None: something in it is wrong
    diagnostics: tuple[Diagnostic, ...]


def read_rows(data: bytes, name: str, tree: Tree, fresh: Intake) -> EditedTable:
    """Return the rows of a table; the files it names are looked into again.

    Hand-ins that no row is about follow as they were found: nobody is forgotten.

    Args:
        data: Content of the table.
        name: What diagnostics call it.
        tree: The download it is about.
        fresh: What the intake finds in the download now.
    """
    source = read_text(data[:LARGEST], name)
    problems = Problems(source)
    lines = table(source, COLUMNS)
    columns = [cell.text.strip().casefold() for cell in lines[0]] if lines else []
    lacking = [column for column in REQUIRED if column not in columns]
    if is_zip(data):
        workbook = f"`{name}` is a workbook, and no table of text"
        problems.error(INTAKE_TABLE, workbook, None, help=("save it as `CSV UTF-8`",))
        return EditedTable(None, problems.in_order())
    if lacking or len(data) > LARGEST:
        names = ", ".join(f"`{column}`" for column in lacking)
        problems.error(
            INTAKE_TABLE,
            f"`{name}` has no column {names}" if lacking else f"`{name}` is too large",
            Span(source, 0, len(source.line_text(1))) if lacking else None,
            help=("save it as `CSV UTF-8`, with the names of the columns in the first line",),
        )
        return EditedTable(None, problems.in_order())
    reader = _Reader(problems, tree, columns, fresh)
    rows = tuple(row for line in lines[1:] if (row := reader.row(line)) is not None)
    if reader.is_of_another():
        return EditedTable(None, (_of_another(name, len(reader.missing), lines[0][0].span),))
    reader.tell_missing()
    more = _unlisted(rows, fresh)
    if more:
        _tell(problems, more, lines[0][0].span)
    return EditedTable(None if problems.any_error else (*rows, *more), problems.in_order())


class _Reader:
    """Reads lines of one table."""

    def __init__(
        self,
        problems: Problems,
        tree: Tree,
        columns: Sequence[str],
        fresh: Intake,
    ) -> None:
        self._problems = problems
        self._tree = tree
        self._columns = columns
        self._flags = _flags(fresh)  # by file: whether the platform calls it late
        self._whys = {row.file: row.why for row in fresh.rows}  # as found
        self._taken: dict[str, Span] = {}  # identifiers
        self._there = 0  # files that rows name, and that are in the download
        self.missing: list[tuple[str, Span]] = []  # those that are not

    def row(self, line: Sequence[Cell]) -> Row | None:
        cells = dict(zip(self._columns, line, strict=False))
        nowhere = Cell("", line[0].span)
        get = {column: cells.get(column, nowhere) for column in COLUMNS}
        identifier = self._identifier(get["id"])
        file, flaw = self._file(get["file"])
        named = file is not None or bool(get["file"].text.strip())
        problem = self._problem(get["problem"], get["file"].span, flaw, named=named)
        received = self._time(get["received"], "received")
        attempts, counted = self._attempts(get["attempts"])
        others = tuple(get["others"].text.split("\n")) if get["others"].text else ()
        flagged = self._flagged(file, others)
        why = get["why"].text.strip()
        if file is not None and file == counted:  # chosen by vrts: to be chosen again among all
            attempts = tuple(_at(one, received) if one.file == file else one for one in attempts)
            file, received = attempts[-1]
        elif file is not None and problem is None and file != _of_vrts(attempts, counted):
            attempts = (Attempt(file, received),)
        if len(attempts) > 1:
            why = self._whys.get(file, why)
        if identifier is None:
            return None
        return Row(
            identifier,
            Student(
                get["name"].text.strip(),
                get["email"].text.strip(),
                get["login"].text.strip(),
                self._ids(get["ids"]),
            ),
            file,
            why,
            received,
            flagged,
            self._late(get["late"], flagged),
            self._time(get["due"], "due"),
            attempts,
            others,
            get["group"].text.strip(),
            problem,
        )

    def _identifier(self, cell: Cell) -> str | None:
        identifier = normalize("NFC", cell.text.strip())
        if not identifier or safe(identifier) != identifier:
            headline = f"`{identifier}` cannot be an id" if identifier else "a row has no id"
            remedy = f"`{safe(identifier)}` would do" if identifier else "write a short name"
            self._problems.error(
                INTAKE_ID,
                headline,
                cell.span,
                notes=("folders of results have this name, on any system",),
                help=(remedy,),
            )
            return None
        earlier = self._taken.setdefault(same_name(identifier), cell.span)
        if earlier is not cell.span:
            self._problems.error(
                INTAKE_ID,
                f"two rows have the id `{identifier}`",
                cell.span,
                "again here",
                secondary=(Label(earlier, "first here"),),
                help=("delete one of the rows, or give it another id",),
            )
            return None
        return identifier

    def _file(self, cell: Cell) -> tuple[str | None, Problem | None]:
        """Return the file a row names, and what is wrong with its content."""
        name = normalize("NFC", cell.text.strip("\n"))
        if not name.strip() and name not in self._tree.files:
            return None, None
        candidate = inspect(self._tree, name) or inspect(self._tree, name.strip())
        if candidate is None:
            self.missing.append((name, cell.span))
            return None, None
        self._there += 1
        return candidate.file, candidate.problem

    def is_of_another(self) -> bool:
        """Return whether no file that rows name is in the download, and not for lost letters."""
        lost = any("?" in name or "�" in name for name, _ in self.missing)
        return len(self.missing) > 1 and not self._there and not lost

    def tell_missing(self) -> None:
        """Report the files that are not in the download."""
        for name, span in self.missing:
            self._no_file(name, span)

    def _no_file(self, name: str, span: Span) -> None:
        close = get_close_matches(name, self._tree.files, 1, 0.6)
        remedies = (f"did you mean `{close[0]}`?",) if close else ()
        if "?" in name or "�" in name:
            remedies = ("letters were lost: save the table as `CSV UTF-8`", *remedies)
        usual = "write the name with its folders; a file in a zip is `work.zip!pick.v2`"
        headline = f"there is no file `{name}` in the download"
        self._problems.error(INTAKE_FILE, headline, span, help=remedies or (usual,))

    def _problem(
        self, cell: Cell, file: Span, flaw: Problem | None, *, named: bool
    ) -> Problem | None:
        """Return what keeps a row from being marked: the teacher's word, or that of the file."""
        text = cell.text.strip()
        word, _, sentence = (part.strip() for part in text.partition(":"))
        kinds = {kind.value: kind for kind in Kind}
        kind = kinds.get(word.casefold())
        if text and kind is None:
            close = get_close_matches(word.casefold(), kinds, 1, 0.6)
            self._problems.error(
                INTAKE_PROBLEM,
                f"unknown problem `{word}`",
                cell.span,
                notes=(f"known: {', '.join(f'`{value}`' for value in kinds)}",),
                help=(f"did you mean `{close[0]}`?",)
                if close
                else ("leave it empty to have the file marked; `excused` to leave the row out",),
            )
            return None
        if kind is Kind.EXCUSED:
            return Problem(kind, sentence or "excused by the teacher")
        if named:
            return flaw
        if kind is None:
            self._problems.error(
                NOTHING_CHOSEN,
                "a row names neither a file nor a problem",
                file,
                help=("write a file of the download, or `missing` or `excused` as its problem",),
            )
            return None
        return Problem(kind, sentence or kind.value)

    def _time(self, cell: Cell, what: str) -> datetime | None:
        text = cell.text.strip()
        if not text:
            return None
        try:
            time = datetime.fromisoformat(text)
        except ValueError:
            time = None
        if time is None or time.tzinfo is None:
            self._value(cell, f"`{what}` must be a time with its offset from UTC")
            return None
        return time

    def _flagged(self, file: str | None, others: Sequence[str]) -> bool | None:
        """Return what the platform says of what was handed in; None for a file from elsewhere."""
        flags = [self._flags.get(name) for name in (others if file is None else (file,))]
        return any(flags) if flags and None not in flags else None

    def _late(self, cell: Cell, flagged: bool | None) -> bool | None:
        """Return what the teacher says; None where it is what the platform says anyway."""
        text = cell.text.strip().casefold()
        if text not in (YES, NO, ""):
            self._value(
                cell, f"`late` must be `{YES}`, `{NO}` or empty", f"write `{YES}` or `{NO}`"
            )
        if text == YES:
            return None if flagged else True
        return False if text == NO else None

    def _ids(self, cell: Cell) -> dict[str, str]:
        found: dict[str, str] = {}
        known = [platform.value for platform in Platform]
        for part in filter(None, map(str.strip, cell.text.split(";"))):
            platform, _, value = part.partition(" ")
            if platform.casefold() not in known or not value.strip():
                shown = ", ".join(f"`{name} 123`" for name in known)
                self._value(cell, f"`{part}` is no id of a platform", f"write such as {shown}")
                continue
            found[platform.casefold()] = value.strip()
        return found

    def _attempts(self, cell: Cell) -> tuple[tuple[Attempt, ...], str | None]:
        """Return the attempts, and the file of the one that vrts chose; None: the latest."""
        found: list[Attempt] = []
        chosen: str | None = None
        for line in filter(None, cell.text.split("\n")):
            told_of = line.removeprefix(f"{COUNTS} ")
            time, _, name = told_of.partition(" ")
            file, flaw = self._file(Cell(name, cell.span))
            told = "" if time == UNKNOWN_TIME else time
            received = self._time(Cell(told, cell.span), "attempts")
            if file is not None and flaw is None:
                found.append(Attempt(file, received))
                chosen = chosen if told_of == line else file
        return tuple(found), chosen

    def _value(
        self, cell: Cell, headline: str, remedy: str = "write such as 2026-11-30T23:59:00+01:00"
    ) -> None:
        self._problems.error(INTAKE_VALUE, headline, cell.span, help=(remedy,))


def _of_vrts(attempts: tuple[Attempt, ...], counted: str | None) -> str | None:
    """Return the file that vrts chose among attempts; another one was chosen by the teacher."""
    return counted or (attempts[-1].file if attempts else None)


def _at(attempt: Attempt, received: datetime | None) -> Attempt:
    return attempt if received is None else attempt._replace(received=received)


def _of_another(name: str, count: int, span: Span) -> Diagnostic:
    headline = f"`{name}` is not about this download: none of its {count} files is in it"
    remedies = ("name the right table with `--intake`", "without a table all is taken as found")
    return error(OTHER_DOWNLOAD, headline, Label(span), help=remedies)


def _unlisted(rows: tuple[Row, ...], fresh: Intake) -> list[Row]:
    """Return hand-ins that no row is about, as those that came after the table was written."""
    ids = {same_name(row.identifier) for row in rows}
    files = {file for row in rows for file in _files(row)}
    persons = {pair for row in rows for pair in row.student.ids.items()}
    return [
        row
        for row in fresh.rows
        if same_name(row.identifier) not in ids
        and not files.intersection(_files(row))
        and not persons.intersection(row.student.ids.items())
    ]


def _tell(problems: Problems, more: list[Row], span: Span) -> None:
    names = ", ".join(f"`{row.identifier}`" for row in more[:SHOWN])
    rest = f" and {len(more) - SHOWN} more" if len(more) > SHOWN else ""
    what = "hand-in is" if len(more) == 1 else "hand-ins are"
    problems.warning(
        NOT_IN_TABLE,
        f"{len(more)} {what} in the download, but not in the table",
        span,
        notes=(f"{names}{rest}",),
        help=("they are taken as found; to leave one out, give it a row that says `excused`",),
    )


def _flags(fresh: Intake) -> dict[str, bool]:
    """Return the files of which a platform tells whether they are late."""
    rows = [row for row in fresh.rows if row.flagged is not None]
    return {file: bool(row.flagged) for row in rows for file in _files(row)}


def _files(row: Row) -> set[str]:
    """Return the files a row is about."""
    named = {row.file} if row.file else set[str]()
    return named | set(row.others) | {attempt.file for attempt in row.attempts}
