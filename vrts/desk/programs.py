"""Programs as they were handed in, read from the download when they are looked at."""

import threading
from collections import OrderedDict
from typing import Final

from msgspec.structs import replace

from vrts.desk.book.book import Book, found_out
from vrts.desk.book.shelf import sentence
from vrts.desk.rows.row_view import source_of
from vrts.desk.told import SourceTold
from vrts.marking.appeals.handed_in import handed_in
from vrts.marking.appeals.written import Written
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

KEPT: Final = 64  # programs that were looked at last


class Programs:
    """Reads programs, and keeps the last. Any thread may ask."""

    def __init__(self) -> None:
        """Begin with none."""
        self._kept: OrderedDict[tuple[str, str], SourceTold] = OrderedDict()
        self._lock = threading.Lock()

    def of(self, book: Book, student: str) -> tuple[SourceTold | None, str | None]:
        """Return a student's program, or None and why there is none to show."""
        row = book.by_id[student]
        program = found_out(row).program
        if program is None:
            return None, None
        key = (student, program.sha256)
        with self._lock:
            if key in self._kept:
                self._kept.move_to_end(key)
                return self._kept[key], None
            opened = book.opened
            whose = replace(row, result=found_out(row))
            try:
                data = handed_in(Written(opened.layout, book.rows, opened.about), whose, None)
            except (CannotRead, Refused) as problem:
                return None, sentence(problem)
            if data is None:
                return None, None
            self._kept[key] = source_of(program.name, data)
            if len(self._kept) > KEPT:
                self._kept.popitem(last=False)
            return self._kept[key], None
