"""`vrts replay`."""

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import click

from vrts.cli.shared.console import STDOUT, WRONG, fail, guarded, out, say, write_file
from vrts.cli.shared.options import file_option, no_open_option
from vrts.cli.shared.run_page import assessed, open_page, write_page

if TYPE_CHECKING:
    from vrts.engine.run import Run
    from vrts.report.assessment import Assessment
    from vrts.report.voices.rows import Voice

RUN = ".vrun"
EPILOG = """\b
Examples:
  vrts replay log-3f2a90bc.jsonl
  vrts replay log-3f2a90bc.jsonl --page -o session.html --no-open
  vrts replay out.vrun --page
  vrts replay log-3f2a90bc.jsonl --session 2 --csv motion.csv
"""


@click.command(name="replay", epilog=EPILOG)
@click.argument("file", type=click.Path(path_type=Path))
@click.option("--session", type=click.IntRange(1), help="Which session; without it the last.")
@click.option("--scene", help="Scene or task, if the library has none with the log's name.")
@file_option("--csv", "table", help="Write a table.")
@click.option("--rate", type=click.IntRange(1, 1000), default=50, help="Rows a second.")
@click.option(
    "--more",
    type=click.FloatRange(0.0, 3600.0),
    default=10.0,
    show_default=True,
    help="How long to go on after the last command [s].",
)
@click.option(
    "--page", is_flag=True, help="See it move in the browser, forward and backward, at any speed."
)
@file_option("-o", "--output", "target", help="File for the page.")
@no_open_option("Write the page (see -o), but open nothing.")
@guarded
def command(
    file: Path,
    session: int | None,
    scene: str | None,
    table: Path | None,
    rate: int,
    more: float,
    page: bool,
    target: Path | None,
    no_open: bool,
) -> None:
    """Repeat a live session from its exported log FILE, exactly, and print what happened.

    The log's chain is checked first. Supervisors get logs from the panel Lead of the page.
    FILE may also be a run that `vrts run --save` has written (.vrun).
    """
    if (target is not None or no_open) and not page:
        fail("`--output` and `--no-open` are about the page", ("give `--page` too",))
    if file.suffix == RUN:
        if scene is not None or session is not None:
            fail(f"`{file.name}` is one run, and its scene is in it")
        run, of_log = _saved(file), None
    else:
        run, of_log = _repeated(file, session, scene, more)
    _tell(run, of_log)
    if table is not None:
        from vrts.report.formats.run_csv import run_csv

        write_file(table, "".join(run_csv(run, rate)).encode())
        say(f"wrote {table}")
    if page:
        opens = not no_open and str(target) != STDOUT  # nobody opens what went to stdout
        _show(file, run, of_log, target, opens=opens)


def _saved(file: Path) -> "Run":
    """Return a run that was saved."""
    from vrts.pipeline.files import read_bytes, shown
    from vrts.run_files.loading import load_run

    run = load_run(read_bytes(file), shown(file), file.parent).run
    assert run is not None
    return run


class _OfLog(NamedTuple):
    """What is known of a session beside its run."""

    found: "Assessment"
    voices: "tuple[Voice, ...]"
    more: int  # checks at marking


def _repeated(
    log: Path, session: int | None, scene: str | None, more: float
) -> "tuple[Run, _OfLog]":
    """Return the run of a session of a log, and what is known of it beside."""
    from vrts.live.logs.log_file import LogFault, read_log
    from vrts.live.logs.shown_session import shown_session
    from vrts.live.logs.voices import voices_of
    from vrts.live.places import places_of
    from vrts.live.session.again.replay import replay
    from vrts.live.session.channel.messages import Start
    from vrts.live.session.setting import setting_of
    from vrts.pipeline.files import read_bytes

    data = read_bytes(log)
    try:
        sessions = read_log(data)
    except LogFault as problem:
        fail(str(problem), status=WRONG)
    if not sessions:
        fail("the log holds no session", status=WRONG)
    number = session or len(sessions)
    if number > len(sessions):
        fail(f"the log holds {len(sessions)} sessions")
    chosen = sessions[number - 1]
    place = places_of((scene or chosen.scene,))[0]
    end = chosen.entries[-1].at_s if chosen.entries else 0.0
    start = Start(chosen.number, "", place.scene, place.task)
    try:
        setting = setting_of(start)
        run = replay(start, chosen.entries, end + more, setting)
    except ValueError as problem:
        fail(f"the log does not fit: {problem}", status=WRONG)
    say(
        f"the chain is unbroken; session {number} of {len(sessions)} in {chosen.scene},"
        f" {len(chosen.entries)} commands, {run.until_s:.3f} s"
    )
    found = shown_session(log.stem, log.name, setting, run)
    voices = voices_of(data, number - 1, (), run.horizon_s)
    return run, _OfLog(found, voices, setting.more)


def _tell(run: "Run", of_log: _OfLog | None) -> None:
    """Print what happened, who said and did what meanwhile, and the mark."""
    from vrts.report.event_words import event_text
    from vrts.report.plain import plain_text

    rows = [(e.time_s, shown[1]) for e in run.events if (shown := event_text(e)) is not None]
    if of_log is not None:
        rows += [(v.at_s, f"{v.name or 'somebody'}: {v.text}") for v in of_log.voices]
    for time_s, text in sorted(rows, key=lambda row: row[0]):
        out(f"{time_s:9.3f}  {plain_text(text)}")
    if of_log is not None and of_log.found.grade is not None:
        _tell_mark(of_log.found)


def _tell_mark(found: "Assessment") -> None:
    """Print the mark by the public checks, and what every point was lost by."""
    from vrts.report.plain import one_line, plain_text, yes_no
    from vrts.report.quantities import full, lost, mark

    task, grade = found.task, found.grade
    assert task is not None
    assert grade is not None
    title = plain_text(one_line(task.title))
    ready = yes_no(grade.ready)
    out(f"{mark(grade.mark)} / {full(grade.total)}  {title}; ready for the real robot: {ready}")
    for loss in grade.losses:
        out(f"{lost(loss.points):>9}  {plain_text(one_line(loss.sentence))}")


def _show(
    file: Path, run: "Run", of_log: _OfLog | None, target: Path | None, *, opens: bool
) -> None:
    """Write the page, and open it."""
    name = f"{file.stem}.html"
    elsewhere = Path(name) if not opens else Path(tempfile.mkdtemp(prefix="vrts-")) / name
    path = target or elsewhere
    if of_log is None:
        write_page(assessed(file.stem, file.name, run), path)
    else:
        write_page(of_log.found, path, of_log.voices, more=of_log.more)
    if target is not None or not opens:
        say(f"wrote {path}")
    if opens:
        open_page(path)
