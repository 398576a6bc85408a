"""`vrts replay`."""

from pathlib import Path

import click

from vrts.cli.console import WRONG, fail, guarded, out, say, write_file

EPILOG = """\b
Examples:
  vrts replay log-3f2a90bc.jsonl
  vrts replay log-3f2a90bc.jsonl --session 2 --csv motion.csv
"""


@click.command(name="replay", epilog=EPILOG)
@click.argument("log", type=click.Path(path_type=Path))
@click.option("--session", type=click.IntRange(1), help="Which session; else the last.")
@click.option("--scene", help="Scene or task, where the library has none of the log's name.")
@click.option("--csv", "table", type=click.Path(path_type=Path), help="Write a table.")
@click.option("--rate", type=click.IntRange(1, 1000), default=50, help="Rows a second.")
@click.option(
    "--more",
    type=click.FloatRange(0.0, 3600.0),
    default=10.0,
    show_default=True,
    help="How long to go on after the last command [s].",
)
@guarded
def command(
    log: Path, session: int | None, scene: str | None, table: Path | None, rate: int, more: float
) -> None:
    """Repeat a live session from its exported LOG, exactly, and print what happened.

    The log's chain is verified first. Supervisors fetch logs from the people panel of the page.
    """
    from vrts.live.log_file import LogFault, read_log
    from vrts.live.places import places_of
    from vrts.live.session.messages import Start
    from vrts.live.session.replay import replay
    from vrts.pipeline.files import read_bytes
    from vrts.report.event_words import event_text
    from vrts.report.plain import plain_text

    try:
        sessions = read_log(read_bytes(log))
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
        run = replay(start, chosen.entries, until_s=end + more)
    except ValueError as problem:
        fail(f"the log does not fit: {problem}", status=WRONG)
    for event in run.events:
        shown = event_text(event)
        if shown is not None:
            out(f"{event.time_s:9.3f}  {plain_text(shown[1])}")
    say(
        f"the chain is unbroken; session {number} of {len(sessions)} in {chosen.scene},"
        f" {len(chosen.entries)} commands, {run.until_s:.3f} s"
    )
    if table is not None:
        from vrts.report.run_csv import run_csv

        write_file(table, "".join(run_csv(run, rate)).encode())
        say(f"wrote {table}")
