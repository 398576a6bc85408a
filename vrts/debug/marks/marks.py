"""Marks: places of a run with a name. They may be kept in a file beside the program or the run."""

import json
import re
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, NamedTuple, cast

from vrts.debug.evaluating import CannotTell
from vrts.debug.marks.same import comes_to, sign_of
from vrts.debug.near import near_words
from vrts.debug.passages import Instant
from vrts.debug.stops.stop import Stop, Why
from vrts.engine.run import Run
from vrts.report.plain import one_line

SUFFIX = ".marks"
SCHEMA = "vrts.marks/1"
MOST = 1_000
MOST_BYTES = 1_000_000
_NAME = re.compile(r"[A-Za-z_][\w.-]{0,39}", re.ASCII)


class Mark(NamedTuple):
    """A place with a name."""

    name: str
    instant: Instant
    process: bool  # whose step is looked at
    words: str  # where that is: "main 5, line 6"
    sign: str  # of the state there


class Marks:
    """The marks of one session."""

    def __init__(self, file: Path | None = None) -> None:
        """Take the file of marks, which is read if it is there; None: they are not kept."""
        self._file = file
        self._known: dict[str, Mark] = {}
        self.kept = False  # in the file
        self.problem = ""  # why the file cannot be read
        if file is not None:
            self._read(file)

    def all(self) -> list[Mark]:
        """Return the marks by time."""
        return sorted(self._known.values(), key=lambda mark: (mark.instant, mark.name))

    def add(self, run: Run, name: str, instant: Instant, words: str, *, process: bool) -> Mark:
        """Give an instant of a run a name; a mark that has it already is moved.

        Raises:
            CannotTell: It is no name, or there are too many.
            OSError: The file cannot be written; the mark is there then, and not in the file.
        """
        if _NAME.fullmatch(name) is None:
            raise CannotTell(
                "the name of a mark is a letter, and at most 39 letters, digits, . _ -"
            )
        if name.lower() not in self._known and len(self._known) >= MOST:
            raise CannotTell(f"there are {MOST:,} marks already: `unmark` takes some away")
        mark = Mark(name, instant, process, words, sign_of(run, instant))
        self._known[name.lower()] = mark
        self._write()
        return mark

    def remove(self, name: str) -> None:
        """Take a mark away; `all` takes all of them.

        Raises:
            CannotTell: There is no such mark.
            OSError: The file cannot be written.
        """
        if name.lower() == "all" and name.lower() not in self._known:
            self._known.clear()
        else:
            del self._known[self.named(name).name.lower()]
        self._write()

    def named(self, name: str) -> Mark:
        """Return a mark.

        Raises:
            CannotTell: There is none of this name.
        """
        found = self._known.get(name.lower())
        if found is None:
            near = near_words(name.lower(), self._known)
            raise CannotTell(f"there is no mark `{one_line(name)[:60]}`{near}")
        return found

    def keep(self) -> Path:
        """Write them to the file, now and whenever they change.

        Raises:
            CannotTell: There is no place for it, or something else is there.
            OSError: It cannot be written.
        """
        if self._file is None:
            raise CannotTell("these marks have no file to be kept beside")
        if self.problem:
            raise CannotTell(f"{self._file.name} is left as it is: {self.problem}")
        self.kept = True
        self._write()
        return self._file

    def _write(self) -> None:
        if not self.kept or self._file is None:
            return
        rows = [
            {
                "name": mark.name,
                "time_s": mark.instant.time_s,
                "statements": mark.instant.finished,
                "process": mark.process,
                "words": mark.words,
                "sign": mark.sign,
            }
            for mark in self.all()
        ]
        text = json.dumps({"schema": SCHEMA, "marks": rows}, indent=1, ensure_ascii=True)
        draft = self._file.with_name(f".{self._file.name}.part")
        draft.write_text(f"{text}\n", "ascii")
        draft.replace(self._file)

    def _read(self, file: Path) -> None:
        try:
            with file.open("rb") as opened:
                data = opened.read(MOST_BYTES + 1)
        except FileNotFoundError:
            return
        except OSError as problem:
            self.problem = (problem.strerror or "it cannot be read").lower()
            return
        try:
            if len(data) > MOST_BYTES:
                raise ValueError(f"it has more than {MOST_BYTES // 1_000_000} MB")
            self._known = {mark.name.lower(): mark for mark in _read_marks(json.loads(data))}
            self.kept = True
        except (ValueError, RecursionError) as problem:
            self.problem = f"it holds no marks: {one_line(str(problem))[:100]}"


def stop_at(run: Run, mark: Mark) -> Stop:
    """Return where to stand at a mark.

    Raises:
        CannotTell: The run is something else there.
    """
    if not is_there(run, mark):
        raise CannotTell(
            f"this run is another one at `{mark.name}`, which was {mark.words} at"
            f" {mark.instant.time_s:.3f} s: `at {mark.instant.time_s:.3f}` goes to the time"
        )
    return Stop(mark.instant, Why.GO, f"mark {mark.name}", process=mark.process)


def is_there(run: Run, mark: Mark) -> bool:
    """Return whether a run comes to a mark, and everything is there as it was."""
    return comes_to(run, mark.instant) and sign_of(run, mark.instant) == mark.sign


def _read_marks(data: object) -> Iterable[Mark]:
    fields: Mapping[str, Any] = cast("Mapping[str, Any]", data) if isinstance(data, dict) else {}
    rows: object = fields.get("marks")
    if fields.get("schema") != SCHEMA or not isinstance(rows, list):
        raise ValueError(f"its schema is not {SCHEMA}")
    found = [_mark(row) for row in cast("list[object]", rows)]
    if len(found) > MOST:
        raise ValueError(f"there are more than {MOST:,}")
    return found


def _mark(row: object) -> Mark:
    match row:
        case {
            "name": str(name),
            "time_s": float() | int() as time_s,
            "statements": int(finished),
            "process": bool(process),
            "words": str(words),
            "sign": str(sign),
        } if _NAME.fullmatch(name) and abs(time_s) < 1e9 and len(words) <= 500:
            return Mark(name, Instant(float(time_s), finished), process, one_line(words), sign)
        case _:
            raise ValueError("a mark is not of the form that they have")
