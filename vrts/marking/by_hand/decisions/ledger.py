"""All that graders have written down: the lines of their files, as records."""

import hashlib
from collections.abc import Iterable, Iterator, Mapping
from types import MappingProxyType
from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.marking.by_hand.decisions.graders import ID, Grader
from vrts.marking.by_hand.decisions.records import Beginning, Decision, Forgotten, Line
from vrts.marking.by_hand.decisions.sound import flaw_of
from vrts.marking.row import CountedFile
from vrts.report.plain import one_line

DAMAGED = Rule("V759", "decisions-damaged")
HALF_WRITTEN = Rule("V766", "decision-half-written")
NOT_DECISIONS = Rule("V845", "not-decisions")

ENDING = ".jsonl"
LARGEST_FILE = 32_000_000  # bytes
LARGEST_LINE = 1_000_000  # bytes
MOST_FILES = 100
MOST_RECORDS = 100_000  # in one file
MOST_TOLD = 20  # damaged lines of one file
PUT_BACK = "put the line back as it was, from a copy or from version control"
FOREIGN_LINE = "delete it only if vrts has not written it"

_DECODER = msgspec.json.Decoder(Line)
_BEGINNING = msgspec.json.Decoder(Beginning)


class Filed(NamedTuple):
    """A record, and whose it is."""

    name: str  # such as huber:12
    grader: str  # id
    who: str  # as people call them
    said: Decision


class Ledger(NamedTuple):
    """What is in the files of all graders of a class."""

    graders: tuple[Grader, ...] = ()  # by id
    records: tuple[Filed, ...] = ()  # by grader and number
    diagnostics: tuple[Diagnostic, ...] = ()
    revision: str = hashlib.sha256().hexdigest()  # another one wherever a byte differs
    counts: tuple[CountedFile, ...] = ()  # of each file its whole lines
    last: Mapping[str, int] = MappingProxyType({})  # number of the last record, by grader

    @property
    def wrong(self) -> bool:
        """Whether something cannot be read; no mark may rest on the rest then."""
        return any(diagnostic.is_error for diagnostic in self.diagnostics)

    @property
    def names(self) -> dict[str, str]:
        """What graders are called, by id."""
        return {grader.id: grader.name for grader in self.graders}


NONE = Ledger()


def ledger_of(files: Mapping[str, bytes], before: Iterable[CountedFile] = ()) -> Ledger:
    """Return what is in files, whatever their order; damaged lines are told, and the rest is kept.

    Args:
        files: Bytes of the files of graders, by their name with its ending.
        before: What was in them when lists of marks were written: it must still be there.
    """
    graders: list[Grader] = []
    records: list[Filed] = []
    last: dict[str, int] = {}
    found: list[Diagnostic] = []
    revision = hashlib.sha256()
    for name in sorted(files):
        data = files[name]
        revision.update(f"{name}\0{hashlib.sha256(data).hexdigest()}\n".encode())
        one = _File(name)
        one.read(data)
        found += one.diagnostics
        if one.grader is not None:
            graders.append(one.grader)
            records += one.records
            last[one.grader.id] = one.last
    found += _lost(files, before)
    counts = tuple(
        one for name in sorted(files) if (one := _counted(name.removesuffix(ENDING), files[name]))
    )
    digest = revision.hexdigest()
    return Ledger(tuple(graders), tuple(records), tuple(found), digest, counts, last)


def _counted(grader: str, data: bytes, most: int | None = None) -> CountedFile | None:
    """Return how many whole lines a file has, or the first of them; None where it has none.

    However version control has written line ends.
    """
    whole, _ = lines_of(data)
    lines = whole[:most]
    text = b"".join(line.removesuffix(b"\r") + b"\n" for line in lines)
    return CountedFile(grader, len(lines), hashlib.sha256(text).hexdigest()) if lines else None


def _lost(files: Mapping[str, bytes], before: Iterable[CountedFile]) -> Iterator[Diagnostic]:
    """Yield an error for every file that has lost lines on which lists of marks rest."""
    for one in before:
        name = f"{one.grader}{ENDING}"
        data = files.get(name)
        now = None if data is None else _counted(one.grader, data, one.lines)
        if now == one:
            continue
        lines = "1 line" if one.lines == 1 else f"{one.lines} lines"
        if data is None:
            what = "is not there"
        elif now is None or now.lines < one.lines:
            what = f"has only {0 if now is None else now.lines} of them"
        else:
            what = "has other ones"
        yield error(
            DAMAGED,
            f"the lists of marks rest on {lines} of `{name}`, which {what}",
            notes=("no mark is made without them: they would be lost without a word",),
            help=(
                "put the file back, from a copy or from version control; `--undo NAME` undoes",
                "if it is lost for good, mark into another folder, with the files that are left",
            ),
        )


def lines_of(data: bytes) -> tuple[list[bytes], bytes]:
    """Return the lines of a file, and what stands behind the last line end."""
    *whole, rest = data.split(b"\n")
    return whole, rest


class _File:
    """One file, as it is read."""

    def __init__(self, name: str) -> None:
        self.name = name
        self.grader: Grader | None = None
        self.records: list[Filed] = []
        self.last = 0  # number of the last record
        self.diagnostics: list[Diagnostic] = []

    def read(self, data: bytes) -> None:
        identifier = self.name.removesuffix(ENDING)
        if not ID.match(identifier) or not self.name.endswith(ENDING):
            self._wrong(
                "is not called as files of graders are",
                "call it as it was called: small letters, digits and `-`, then `.jsonl`",
            )
            return
        if len(data) > LARGEST_FILE:
            self._wrong(f"has more than {LARGEST_FILE:,} bytes", PUT_BACK)
            return
        lines, rest = lines_of(data)
        if not lines and not rest:
            self._wrong("is empty", "delete it: nothing is decided in it")
            return
        self._begin(lines[0] if lines else rest, identifier)
        if self.grader is None:
            return
        number = 0
        for place, line in enumerate(lines[1:], 2):
            number = self._line(place, line, number)
            if len(self.diagnostics) > MOST_TOLD:
                return
            if number > MOST_RECORDS:
                self._wrong(
                    f"has more than {MOST_RECORDS:,} records",
                    "let the grader go on under another name",
                )
                return
        if lines and rest:
            self._last(len(lines) + 1, rest, number)

    def _begin(self, line: bytes, identifier: str) -> None:
        try:
            begun = _BEGINNING.decode(line)
        except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as problem:
            self._wrong(f"line 1 does not say whose it is: {_why(problem)}", PUT_BACK)
            return
        if begun.id != identifier:
            self._wrong(
                f"says that it is `{begun.id}{ENDING}`",
                f"call it `{begun.id}{ENDING}`; delete it if it is a copy of that file",
            )
            return
        self.grader = Grader(identifier, one_line(begun.grader))

    def _line(self, place: int, line: bytes, before: int) -> int:
        """Take a line; return the number that the next one follows."""
        said = self._decoded(line)
        if isinstance(said, str):
            merged = line.startswith((b"<<<<<<<", b"=======", b">>>>>>>"))
            remedy = "a merge went wrong here: keep every record once" if merged else PUT_BACK
            self._wrong(f"line {place} is no decision: {said}", remedy)
            return before + 1
        self._numbered(place, said, before)
        self._keep(said)
        return said.number

    def _last(self, place: int, line: bytes, before: int) -> None:
        """Take what stands behind the last line end: whole, or as a crash has left it."""
        said = self._decoded(line)
        if isinstance(said, str):
            headline = f"`{self.name}`: line {place} was not written to its end, and does not count"
            remedy = "decide it again, if it was meant; the next decision takes its place"
            self.diagnostics.append(warning(HALF_WRITTEN, headline, help=(remedy,)))
            return
        self._numbered(place, said, before)
        self._keep(said)

    def _numbered(self, place: int, said: Line, before: int) -> None:
        if said.number == before + 1:
            return
        if said.number <= before:
            what = f"line {place} has the number {said.number}, which was there before"
            remedy = f"two copies of the file went on: give later lines numbers from {before + 1}"
        else:
            what = f"line {place} has the number {said.number}, and {before + 1} is missing"
            remedy = "put the missing line back, from a copy or from version control"
        self._wrong(what, remedy)

    def _keep(self, said: Line) -> None:
        assert self.grader is not None
        self.last = said.number
        if isinstance(said, Forgotten):
            return
        identifier, who = self.grader
        self.records.append(Filed(f"{identifier}:{said.number}", identifier, who, said))

    def _decoded(self, line: bytes) -> Line | str:
        """Return the record in a line, or why there is none."""
        if len(line) > LARGEST_LINE:
            return f"it has more than {LARGEST_LINE:,} bytes"
        try:
            said = _DECODER.decode(line)
        except (msgspec.MsgspecError, UnicodeDecodeError, RecursionError) as problem:
            return _why(problem)
        return flaw_of(said) or said

    def _wrong(self, what: str, remedy: str) -> None:
        between = ": " if what.startswith("line") else " "
        headline = f"`{self.name}`{between}{what}"
        note = "no mark is made while a decision cannot be read"
        remedies = (remedy, FOREIGN_LINE) if remedy == PUT_BACK else (remedy,)
        self.diagnostics.append(error(DAMAGED, headline, notes=(note,), help=remedies))


def _why(problem: Exception) -> str:
    if isinstance(problem, RecursionError):
        return "it is nested too deeply"
    text = one_line(str(problem))
    return text[:1].lower() + text[1:200]
