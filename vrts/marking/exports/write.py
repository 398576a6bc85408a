"""Writes exports of a marking: the one place where files are read and written."""

from collections.abc import Callable, Sequence
from itertools import chain, islice
from pathlib import Path

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.marking.by_hand.excused import excused_result
from vrts.marking.exports.feedback import NAME as FEEDBACK
from vrts.marking.exports.feedback import feedback_text
from vrts.marking.exports.formats import FORMATS
from vrts.marking.exports.given import Given, Options, Page, returned
from vrts.marking.exports.marks_table import NAME as MARKS
from vrts.marking.exports.marks_table import marks_csv
from vrts.marking.exports.unsafe_marks import closing, refusal, unsafe_rows, without_lateness
from vrts.marking.layout import RESULT, Layout, write_atomically
from vrts.marking.privacy.pseudonyms import with_names
from vrts.marking.result import Damaged, Result, from_bytes
from vrts.marking.row import Class, Row
from vrts.marking.submission.report_files import RECORDING, REPORT
from vrts.pipeline.refused import Refused

NO_STUDENT_RESULT = Rule("V749", "no-result-for-student")
EXPORTS = "exports"  # folder in `staff`

Tell = Callable[[Sequence[Diagnostic]], None]


def write_exports(
    names: Sequence[str],
    rows: Class,
    layout: Layout,
    options: Options,
    *,
    tell: Tell,
    wrote: Callable[[Path], None] = lambda _: None,
    target: Path | None = None,
) -> list[Path]:
    """Write a class in some formats: those first whose marks nobody takes for final.

    Args:
        names: Of formats, as in `FORMATS`.
        rows: Of the class.
        layout: Where marking wrote the students' own results and reports.
        options: How to export.
        tell: Takes what there is to say.
        wrote: Takes each place as soon as it is written.
        target: The file to write where there is one only, else the folder; None: the folder
            `staff/exports`.

    Returns:
        The files; of what has a file for each student, the folder.

    Raises:
        Refused: A file of the teacher's cannot be filled in, a student's result is missing, or
            marks that would be taken for final are unsafe, and not for reasons in
            `options.despite`. Formats that this does not concern are written before.
    """
    kept = [name for name in names if _is_kept_back(name, rows, options)]
    free = sorted((name for name in names if name not in kept), key=lambda n: FORMATS[n].final)
    written: list[Path] = []
    given = read_given(rows, layout) if free else None
    for name in free:
        assert given is not None
        form = FORMATS[name]
        source = given._replace(whole=_judged([name], rows))
        if form.names:
            source = source._replace(whole=with_names(source.whole, layout))
        product = form.export(source, options)
        tell(product.diagnostics)
        files = iter(product.files)
        first = list(islice(files, 2))
        if target is not None and len(names) == len(first) == 1 and not target.is_dir():
            write_atomically(target, first[0][1])
            written.append(target)
            wrote(target)
            continue
        home = layout.staff / EXPORTS if target is None else target
        places: dict[Path, None] = {}
        for file, data in chain(first, files):
            write_atomically(home / file, data)
            places[home / Path(file).parts[0]] = None
        for place in places:
            written.append(place)
            wrote(place)
    final = [name for name in free if FORMATS[name].final]
    if final:
        tell(closing(_judged(final, rows)))
    if kept:
        others = kept if free else ()
        raise Refused(refusal(_judged(kept, rows), options.despite, layout.root, others))
    return written


def _is_kept_back(name: str, rows: Class, options: Options) -> bool:
    """Return whether marks in a format would be taken for final, and somebody has to decide."""
    return FORMATS[name].final and bool(unsafe_rows(_judged([name], rows), options.despite))


def _judged(names: Sequence[str], rows: Class) -> Class:
    """Return a class as the strictest of some formats wants it judged."""
    return rows if any(FORMATS[name].lateness for name in names) else without_lateness(rows)


def is_name(identifier: str) -> bool:
    """Return whether an id names a folder beside others, as those of the intake do."""
    return identifier not in ("", ".", "..") and not set("/\\:\0") & set(identifier)


def write_marks_table(rows: Class, layout: Layout) -> Path:
    """Write `staff/marks.csv`, which every marking has, and return its path."""
    path = layout.staff / MARKS
    write_atomically(path, marks_csv(rows))
    return path


def write_feedback(rows: Class, layout: Layout) -> None:
    """Write `feedback.txt` for every student: the final mark, and how it came to be.

    Raises:
        Refused: A student's own result is missing or damaged.
    """
    for told in returned(read_given(rows, layout)):
        write_atomically(layout.student(told.row.id) / FEEDBACK, feedback_text(told))


def read_given(rows: Class, layout: Layout) -> Given:
    """Return what exports are made of.

    Raises:
        Refused: A student's own result is missing or damaged.
    """
    public = {row.id: _told(row, _public(layout, row.id)) for row in rows.rows}

    def pages(identifier: str) -> tuple[Page, ...]:
        home = layout.student(identifier)
        places = (home / name for name in (REPORT, RECORDING))
        return tuple(Page(place.name, place.read_bytes()) for place in places if place.is_file())

    return Given(rows, public, pages)


def _told(row: Row, public: Result) -> Result:
    """Return a student's own result as graders have decided: nothing is asked of the excused."""
    excused = "" if row.decided is None else row.decided.excused
    return excused_result(public, excused) if excused else public


def _public(layout: Layout, identifier: str) -> Result:
    try:
        if not is_name(identifier):
            raise Damaged("an id that is no name of a folder")
        return from_bytes((layout.student(identifier) / RESULT).read_bytes())
    except (OSError, Damaged) as problem:
        headline = f"the result for `{identifier}` is missing or damaged"
        remedy = "mark the class again: what is there already is not made twice"
        notes = (
            f"feedback is made of `students/{identifier}/{RESULT}`, in which nothing hidden is",
        )
        found = error(NO_STUDENT_RESULT, headline, notes=notes, help=(remedy,))
        raise Refused((found,)) from problem
