"""`vrts debug`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    fail,
    guarded,
    out,
    say,
    show_diagnostics,
    write_file,
)
from vrts.cli.shared.options import (
    IN_CELL,
    TASK_OR_ALONE,
    color_option,
    controller_option,
    dialect_option,
    entry_option,
    file_option,
    form_option,
    lab_option,
    overwrite_option,
    placed,
    scenario_option,
    scene_option,
    task_option,
    with_option,
)
from vrts.cli.shared.programs import tell_task
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vrts.debug.opening import Asked, Opened
    from vrts.debug.scripted.reading import Line
    from vrts.debug.scripted.session import Done, Session

EPILOG = """\b
Examples:
  vrts debug prog.v2
  vrts debug prog.v2 --scene cans-on-bases
  vrts debug out.vrun --at 6.2
  vrts debug prog.v2 --break 12 --command 'continue; print i; why' --json
  vrts debug prog.v2 --command 'events where kind = contact; go 1; link'
n and N go a step forward and back, c and C to the next stop and the one before, v and V show the
moment in the browser and in the Rerun viewer, : takes a command; ? shows all keys. With --command
or --commands no terminal is needed, and the exit status is 1 when a command was refused or an
`assert` did not hold. `--command help` lists the commands, --json writes one line for each.
"""
STDIN = "-"


@click.command(name="debug", epilog=EPILOG)
@click.argument("program", type=click.Path(path_type=Path))
@scene_option(TASK_OR_ALONE)
@task_option()
@scenario_option(IN_CELL)
@lab_option
@controller_option
@entry_option("Program to execute; without it the task's, or the main one.")
@with_option()
@dialect_option("Dialect; without it vrts looks at file name and content.", auto=False)
@click.option("--at", "time_s", type=float, help="Begin at this time [s].")
@click.option(
    "--step",
    "statements",
    type=click.IntRange(0),
    help="... where so many statements are finished, as `link` prints it.",
)
@click.option(
    "--break", "points", metavar="LINE[:CONDITION]", multiple=True, help="Stop there; repeatable."
)
@click.option(
    "--command",
    "texts",
    metavar="TEXT",
    multiple=True,
    help="Carry commands out, parted by `;`, and end; repeatable.",
)
@file_option("--commands", "file", help="Carry out a file of commands, and end; `-` is stdin.")
@form_option("full", "json")
@click.option(
    "--limit",
    "limit_s",
    type=click.FloatRange(0.1, 86_400.0),
    default=60.0,
    show_default=True,
    help="How long the commands may take together [s].",
)
@file_option("--record", help="Write a session at the terminal to a file of commands.")
@overwrite_option("Replace the file of --record if it exists already.")
@color_option
@guarded
@placed
def command(
    program: Path,
    where: Where,
    entry: str | None,
    others: tuple[str, ...],
    dialect: str | None,
    time_s: float | None,
    statements: int | None,
    points: tuple[str, ...],
    texts: tuple[str, ...],
    file: Path | None,
    form: str,
    limit_s: float,
    record: Path | None,
    overwrite: bool,
    color: str,
) -> None:
    """Debug PROGRAM with time running both ways: at the terminal, or by commands.

    PROGRAM may be a run that `vrts run --save` has written.
    """
    from vrts.debug.opening import Asked

    lines = _lines(texts, file)
    as_json = form == "json"
    if lines is None and as_json:
        fail("`--format json` goes with commands", ("`--command TEXT` or `--commands FILE`",))
    if lines is None and not (sys.stdin.isatty() and sys.stdout.isatty()):
        hints = ("`--command TEXT` and `--commands FILE` need none", "editors use `vrts dap`")
        fail("debugging needs a terminal", hints)
    if lines is not None and record is not None:
        fail("--record goes with a terminal: these commands are written already")
    if record is not None and record.exists() and not overwrite:
        fail(f"`{record}` is there already", ("give another name, or `--overwrite`",))
    asked = Asked(program, where, entry, tuple(map(Path, others)), dialect)
    found = _opened(asked, color)
    first = [f"break {point}" for point in points]
    if statements is not None and time_s is None:
        fail("`--step` goes with `--at`", ("`link` in the debugger prints both",))
    if time_s is not None:
        first.append(f"at {time_s!r}" + ("" if statements is None else f" step {statements}"))
    if lines is None:
        _at_terminal(asked, found, first, record)
        return
    from vrts.cli.runs.debug_outside import DebugOutside
    from vrts.debug.scripted.session import Session

    assert found.debugger is not None
    assert found.console is not None
    outside = DebugOutside(asked, found)
    session = Session(found.debugger, found.console, outside.restart)
    _begin(session, first)
    sys.exit(_scripted(session, lines, limit_s, as_json=as_json))


def _lines(texts: tuple[str, ...], file: Path | None) -> "Sequence[Line] | None":
    """Return the commands that are given; None: none are, and the terminal gives them."""
    from vrts.debug.scripted.reading import MOST_BYTES, TooMuch, commands_in, commands_of

    if not texts and file is None:
        return None
    try:
        lines = commands_of(texts)
        if file is not None:
            if str(file) == STDIN:
                lines += commands_in(sys.stdin.buffer.read(MOST_BYTES + 1))
            else:
                with file.open("rb") as opened:
                    lines += commands_in(opened.read(MOST_BYTES + 1))
    except TooMuch as problem:
        fail(str(problem))
    return lines


def _opened(asked: "Asked", color: str) -> "Opened":
    from vrts.debug.opening import opened
    from vrts.debug.opening_saved import opened_run
    from vrts.engine.storage.recognise import is_saved_run
    from vrts.pipeline.files import read_bytes

    if is_saved_run(read_bytes(asked.program)):
        if any(asked.where) or asked.entry or asked.others or asked.dialect:
            fail("a saved run has its own scene, scenario and programs")
        found = opened_run(asked.program)
    else:
        tell_task(asked.program, asked.where)
        found = opened(asked)
    if found.debugger is None or found.console is None:
        show_diagnostics(found.diagnostics, color)
        sys.exit(WRONG)
    from vrts.debug.alarms import DEFAULT

    found.debugger.wishes.filters = DEFAULT
    return found


def _begin(session: "Session", first: "Sequence[str]") -> "list[Done]":
    """Carry out what options ask for; end where one is refused."""
    from vrts.debug.scripted.commander import carry_out

    found: list[Done] = []
    for line in first:
        done = carry_out(session, line)
        if not done.ok:
            fail(f"`{line}`: {' '.join(done.said)}")
        found.append(done)
    return found


def _scripted(session: "Session", lines: "Sequence[Line]", limit_s: float, *, as_json: bool) -> int:
    """Carry out commands, tell what each did, and return the exit status."""
    from vrts.debug.scripted.script import performed
    from vrts.debug.scripted.telling import as_text, json_line

    status = HOLDS
    for number, done in enumerate(performed(session, lines, limit_s), start=1):
        if not done.ok:
            status = WRONG
        out(json_line(number, done) if as_json else as_text(done))
    return status


def _at_terminal(
    asked: "Asked", found: "Opened", first: "Sequence[str]", record: Path | None
) -> None:
    from vrts.cli.runs.debug_outside import DebugOutside, recorder
    from vrts.debug.scripted.session import Session
    from vrts.debug.terminal.screen import debug

    assert found.debugger is not None
    assert found.console is not None
    with DebugOutside(asked, found) as outside, recorder(record) as kept:
        session = Session(
            found.debugger, found.console, outside.restart, writes=True, write=write_file
        )
        for done in _begin(session, first):
            kept.add(done)
        debug(session, outside.keys(), kept)
    say(f"left at {found.debugger.at.time_s:.3f} s")
