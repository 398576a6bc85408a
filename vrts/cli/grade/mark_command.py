"""`vrts grade TASK [SUBMISSIONS]...`."""

import os
import random
import shlex
import sys
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.grade.export_command import (
    DECIMALS,
    NAMES,
    decimal_option,
    export,
    given_page,
    require_decimals,
)
from vrts.cli.grade.mark_epilog import EPILOG
from vrts.cli.grade.options import (
    again_option,
    corpus_option,
    despite_option,
    mend_option,
    no_pages_option,
    recordings_option,
    results_option,
    roster_option,
    table_option,
    variants_key_option,
    zone_option,
)
from vrts.cli.grade.what_to_mark import require_folder, what_to_mark
from vrts.cli.shared.console import (
    FAULT,
    HOLDS,
    WRONG,
    fail,
    guarded,
    out,
    say,
    show_diagnostics,
    warn,
)
from vrts.cli.shared.options import (
    color_option,
    engine_option,
    file_option,
    form_option,
    jobs_option,
    lab_option,
    no_collisions_option,
)
from vrts.cli.shared.progress import Progress
from vrts.cli.shared.zones import zone_named

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vrts.marking.about import About
    from vrts.marking.exports.given import Page
    from vrts.marking.layout import Layout
    from vrts.marking.marking import Done
    from vrts.marking.row import Class, Row
    from vrts.marking.similarity.corpus import Corpora
    from vrts.marking.submission.marker import Marker
    from vrts.marking.whole_class import HowTo, Marked


@click.command(name="mark", epilog=EPILOG)
@click.argument("task")
@click.argument("submissions", nargs=-1, type=click.Path(path_type=Path))
@results_option
@jobs_option("Programs at a time; without it one per core.")
@table_option
@variants_key_option
@roster_option()
@zone_option
@click.option(
    "--backend",
    metavar="CLUSTER",
    help="Mark on a cluster: dask, dask:ADDRESS, slurm or htcondor; see below.",
)
@click.option(
    "--export",
    "formats",
    type=click.Choice(NAMES),
    multiple=True,
    metavar="FORMAT",
    help="Write the marks in another format too: see `vrts grade export --help`.",
)
@file_option(
    "--fill",
    metavar="FILE",
    help="The worksheet or grade book to fill in, for `--export moodle` or `canvas`.",
)
@decimal_option()
@despite_option()
@click.option("--verify", is_flag=True, help="Mark a random sample again, and compare.")
@click.option(
    "--sample",
    type=click.IntRange(1),
    default=10,
    show_default=True,
    help="How many programs `--verify` marks again.",
)
@corpus_option()
@click.option(
    "--pseudonyms",
    is_flag=True,
    help="Give ids and files other names; only staff/names.csv says who is who.",
)
@again_option
@no_pages_option()
@recordings_option()
@mend_option()
@no_collisions_option
@engine_option()
@form_option("full", "json")
@lab_option
@color_option
@guarded
def command(
    task: str,
    submissions: tuple[Path, ...],
    folder: Path | None,
    jobs: int | None,
    table: Path | None,
    class_list: Path | None,
    variants_key: Path | None,
    zone: str | None,
    backend: str | None,
    formats: tuple[str, ...],
    fill: Path | None,
    decimal: str | None,
    despite: tuple[str, ...],
    verify: bool,
    sample: int,
    others: tuple[Path, ...],
    pseudonyms: bool,
    again: bool,
    no_pages: bool,
    recordings: bool,
    mend: int,
    no_collisions: bool,
    engine: str | None,
    form: str,
    lab: Path | None,
    color: str,
) -> None:
    """Mark SUBMISSIONS by TASK.

    TASK is a task.toml, its folder, a zip of `vrts task pack`, or the name of an example; an
    example without submissions marks its own. SUBMISSIONS are programs, a folder, or a zip: a
    download of Moodle, Canvas or Gradescope, a folder for each student, or files side by side.

    Every submission gets two reports. `students/ID` in the output is for the student alone.
    `staff/students/ID` is for those who mark: it also shows what to review, facts for an appeal,
    and hidden checks. `staff` holds the marks, the overview of the class, and groups of programs
    that are alike. A second call marks only what has changed since. After an interruption (exit
    status 130) the same call goes on. Exit status 0 when every row has a result.

    With --mend N the results for staff and the overview say which change of a program would earn
    the full mark, and how many made the same mistake. Students learn nothing of it.

    With --pseudonyms the only names of persons and files in the output are in staff/names.csv,
    which only its owner may read. vrts makes the ids with the key in staff/pseudonyms.key: they
    stay the same when the key does. It does not change what students write into their programs.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads do not fork
    from vrts.marking.layout import Layout
    from vrts.marking.privacy.pseudonyms import require_names
    from vrts.marking.remote.backend import read_backend
    from vrts.marking.similarity.corpus import read_corpora
    from vrts.marking.submission.one import Wanted
    from vrts.marking.variants.of_class import marker_for
    from vrts.marking.whole_class import HowTo

    place, found = what_to_mark(task, submissions, lab)
    require_folder(folder)
    pages = folder is not None and not no_pages
    wanted = Wanted(not no_collisions, engine, pages, recordings and folder is not None, mend)
    marker = marker_for(place, wanted, class_list, variants_key)
    layout = None if folder is None else Layout(folder)
    if formats and layout is None:
        fail("`--export` needs a folder for results", ("name it with `-o`",))
    require_decimals(decimal, formats)
    if pseudonyms and layout is None:
        fail("`--pseudonyms` needs a folder for results", ("name it with `-o`",))
    if layout is not None and not pseudonyms:
        require_names(layout)
    if others and layout is None:
        fail("`--corpus` needs a folder for results", ("name it with `-o`",))
    corpora = read_corpora(others, folder)
    page = given_page(fill)
    where = None if backend is None else read_backend(backend)
    how = HowTo(
        jobs or os.cpu_count() or 1,
        again,
        table,
        where,
        class_list,
        zone_named(zone) if zone else None,
        pseudonyms,
    )
    about = _about(marker, [str(path) for path in submissions], pseudonyms=pseudonyms)
    progress = Progress()
    then = "nothing is kept without `-o`" if layout is None else "the same call goes on"
    with progress.interruptible(then):
        rows: Class | None = None
        marked = _mark(marker, found, layout, how, about, progress, quiet=form == "json")
        show_diagnostics((*marker.whole.stamps, *marked.warnings, *corpora.findings), color)
        for remark in marked.remarks:
            say(f"note: {remark}")
        if layout is not None:
            rows = write_lists(marker, marked, layout, about, color, corpora)
    if form == "json":
        from vrts.marking.row import class_to_bytes

        out(class_to_bytes(rows or marked.rows).decode().rstrip("\n"))
    good = not verify or _same_again(marker, marked, sample, how.jobs)
    if layout is not None and formats:
        good = _export(formats, layout, page, despite, decimal, color) and good
    if any(done.result.is_fault for done in marked.done):
        sys.exit(FAULT)
    sys.exit(HOLDS if good else WRONG)


def _same_again(marker: "Marker", marked: "Marked", count: int, jobs: int) -> bool:
    """Mark some programs again, and say what differs; return whether nothing does."""
    from vrts.marking.sample import sampled, verify_sample

    seed = random.SystemRandom().randrange(1_000_000)
    number = len(sampled(marked.done, count, seed))
    unlike = verify_sample(marker, marked.done, count=count, seed=seed, jobs=jobs)
    for one in unlike:
        path, old, new = one.first
        warn(f"`{one.identifier}`: the result {one.whose} differs: {path} was {old}, is {new}")
    say(f"marked {number} again (sample {seed}): {len(unlike) or 'none'} differ")
    return not unlike


def _export(
    formats: "Sequence[str]",
    layout: "Layout",
    page: "Page | None",
    despite: "Sequence[str]",
    decimal: str | None,
    color: str,
) -> bool:
    """Write the marks in other formats, as decided now; return whether all were written."""
    from vrts.marking.exports.given import Options
    from vrts.marking.renewing.renewed import renewed
    from vrts.marking.row import counted
    from vrts.pipeline.refused import Refused

    options = Options(
        page,
        delimiter=";" if decimal == "comma" else ",",
        now=datetime.now(UTC),
        decimal=DECIMALS.get(decimal or "", ""),
        despite=frozenset(despite),
    )
    try:
        export(formats, counted(renewed(layout).rows), layout, options, color)
    except Refused as problem:
        show_diagnostics(problem.diagnostics, color)
        where = shlex.quote(str(layout.root))
        warn(f"help: `vrts grade export {where}` exports what is marked, and takes more options")
        return False
    return True


def _mark(
    marker: "Marker",
    submissions: "Path | Sequence[Path]",
    layout: "Layout | None",
    how: "HowTo",
    about: "About",
    progress: Progress,
    *,
    quiet: bool,
) -> "Marked":
    from vrts.assignments.packed import public_answer
    from vrts.marking.class_files import begin_class
    from vrts.marking.row_words import row_words
    from vrts.marking.whole_class import mark_whole_class

    order: list[str] = []  # ids whose lines are still to come
    waiting: dict[str, tuple[Done, Row]] = {}

    def begun(identifiers: "Sequence[str]") -> None:
        if layout is not None:
            begin_class(about, layout)
        order.extend(identifiers)
        progress.begin(len(order))

    def told(done: "Done", row: "Row") -> None:
        progress.step(reused=done.reused)
        waiting[row.id] = done, row
        while order and order[0] in waiting:
            line(*waiting.pop(order.pop(0)))
        progress.show()

    def line(done: "Done", row: "Row") -> None:
        if quiet:
            return
        progress.clear()
        out(row_words(row, done.entry.title))
        answer = public_answer(done.result.ready, marker.whole)
        if answer is not None:
            out(f"      {answer}")

    marked = mark_whole_class(marker, submissions, layout, how, begun=begun, told=told)
    progress.clear()
    return marked


def _about(marker: "Marker", submissions: "Sequence[str]", *, pseudonyms: bool) -> "About":
    """Return what a marking is that begins now."""
    from vrts import __version__
    from vrts.marking.about import About
    from vrts.marking.privacy.pseudonyms import nameless_about

    assert marker.whole.task is not None
    about = About(
        "vrts.marking/1",
        marker.whole.task.title,
        marker.place,
        tuple(submissions),
        marker.wanted,
        __version__,
        tuple(sys.argv),
        None,
        begun=datetime.now(UTC),
    )
    return nameless_about(about) if pseudonyms else about


def write_lists(
    marker: "Marker",
    marked: "Marked",
    layout: "Layout",
    about: "About",
    color: str,
    corpora: "Corpora | None" = None,
) -> "Class":
    """Write what there is about a class as a whole, and what students get; tell unsafe marks.

    Returns:
        The rows, also with what was decided while they were marked.
    """
    import msgspec

    from vrts.marking.about import Late
    from vrts.marking.exports.unsafe_marks import after_marking
    from vrts.marking.renewing.renewed import link_compared, write_marked
    from vrts.marking.similarity.corpus import NONE
    from vrts.marking.similarity.files import compare_class

    assert marker.whole.task is not None
    about = msgspec.structs.replace(
        about,
        finished=datetime.now(UTC),
        intake_sha256=marked.intake_sha256,
        late=Late.of(marker.whole.task.late),
    )
    rows = write_marked(marked.rows, about, layout)  # first: nothing keeps marks waiting
    compare_class(marked, marker, layout, corpora or NONE)
    link_compared(rows, about, layout)
    say(f"wrote {layout.overview}")
    without = ", without the hidden checks" if marker.hidden else ""
    say(f"wrote {layout.root / 'students'}, to be sent to each{without}")
    show_diagnostics(after_marking(rows, layout.root), color)
    return rows
