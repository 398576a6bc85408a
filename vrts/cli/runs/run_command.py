"""`vrts run`."""

import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import click

from vrts.cli.shared.console import (
    HOLDS,
    STDOUT,
    WRONG,
    fail,
    out,
    say,
    show_diagnostics,
    write_file,
)
from vrts.cli.shared.one_program import executed_so, of_one_program
from vrts.cli.shared.options import (
    TASK_OR_ALONE,
    Language,
    entry_option,
    file_option,
    overwrite_option,
    scenario_option,
)
from vrts.cli.shared.programs import Given, given_program, task_is_beside
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from vrts.engine.run import Run
    from vrts.pipeline.setting import Setting
    from vrts.run_files.simulated import Simulated

EPILOG = """\b
Examples:
  vrts run prog.v2
  vrts run prog.v2 --scene cans-on-bases --at 4.5
  vrts run prog.v2 --scene cans-on-bases --from 10 --to 4 --speed -4
  vrts run prog.v2 --scene cans-on-bases --csv motion.csv --rate 100
  vrts run prog.v2 --scene cans-on-bases --scenario gripper-slips.toml
  vrts run prog.v2 --scene cans-on-bases --lab lab.toml
  vrts run prog.v2 --scene cans-on-bases --mcap run.mcap
  vrts run prog.v2 --save out.vrun
  vrts run out.vrun --at 3.2
"""
ROUNDED_S = 0.0005  # half of the last decimal of a time that is printed
SLOWEST, FASTEST = 0.001, 1e6  # seconds of the run a second
SLOWEST_HZ, FASTEST_HZ = 0.001, 1000.0  # rows of a table: their times have three decimals


class _Span(NamedTuple):
    """The part of a run to show."""

    from_s: float
    to_s: float
    speed: float  # 0: without waiting


@click.command(name="run", epilog=EPILOG)
@of_one_program(TASK_OR_ALONE)
@scenario_option()
@entry_option("Program to execute; without it the main one.")
@click.option(
    "--at", "time_s", type=float, help="Print the state at this time [s], not the output."
)
@click.option(
    "--statement", type=int, help="Print the state after so many statements; EXECUTE is the first."
)
@click.option("--from", "from_s", type=float, help="List what happens from this time on [s].")
@click.option("--to", "to_s", type=float, help="List what happens up to this time [s].")
@click.option(
    "--speed", type=float, help="How many times as fast; negative is backward, 0 does not wait."
)
@click.option("--csv", "table", help="Write a table of arm, tool and signals; `-` is stdout.")
@click.option("--rate", type=float, default=50.0, show_default=True, help="Rows a second, in Hz.")
@file_option("--mcap", help="Write the run as messages of ROS 2, for Foxglove and PlotJuggler.")
@file_option("--save", help="Write the run to a file (.vrun).")
@click.option("--check", is_flag=True, help="Execute a saved run again and compare.")
@overwrite_option()
@executed_so
def command(
    program: str,
    where: Where,
    entry: str | None,
    time_s: float | None,
    statement: int | None,
    from_s: float | None,
    to_s: float | None,
    speed: float | None,
    table: str | None,
    rate: float,
    mcap: Path | None,
    save: Path | None,
    check: bool,
    overwrite: bool,
    language: Language,
    color: str,
) -> None:
    """Run PROGRAM; what it TYPEs goes to stdout, everything else to stderr.

    PROGRAM may be a run that `--save` wrote: it is read, and not executed again. --from, --to and
    --speed list line by line what happened. On a terminal the lines come as fast as it happened,
    unless you give --speed.
    """
    shows = [time_s is not None, statement is not None, table == STDOUT]
    shows.append(from_s is not None or to_s is not None or speed is not None)
    if sum(shows) > 1:
        fail("one of --at, --statement, --from/--to/--speed and --csv - is shown at a time")
    if table is not None and not SLOWEST_HZ <= rate <= FASTEST_HZ:
        fail(f"--rate goes from {SLOWEST_HZ:g} to {FASTEST_HZ:g} Hz")
    if speed and not SLOWEST <= abs(speed) <= FASTEST:
        fail(f"--speed is 0, or from {SLOWEST:g} to {FASTEST:g}, or the same backward")
    written = [
        path for path in (save, mcap, Path(table) if table not in (None, STDOUT) else None) if path
    ]
    for path in written:
        if path.exists() and not overwrite:
            fail(f"`{path}` is there already", ("give another name, or `--overwrite`",))
        if path == Path(program):
            fail(f"`{path}` is what is to be run")
    from vrts.engine.storage.recognise import is_saved_run

    given = given_program(program)
    if is_saved_run(given.program.data):
        if any(where) or entry or language.said:
            fail("a saved run has its own scene, scenario and programs")
        found = _loaded(given, color)
    elif check:
        fail("only a saved run can be checked", ("`--save FILE` writes one",))
    else:
        found = _simulated(given, where, language, entry, color)
    run = found.run
    if run is None:
        sys.exit(WRONG)
    _write_files(found, run, save, table, rate)
    if mcap is not None:
        from vrts.cli.shared.mcap import write_mcap
        from vrts.cli.shared.run_page import assessed

        write_mcap(assessed(Path(program).stem, given.program.name, run), mcap)
    if check:
        _check(found, given.program.name, color)
    elif time_s is not None or statement is not None:
        _show_state(run, time_s, statement)
    elif shows[-1]:
        _replay(run, _span(run, from_s, to_s, speed))
    elif table != STDOUT:
        _show_output(run)
    sys.exit(WRONG if any(d.is_error for d in found.diagnostics) else HOLDS)


def _simulated(
    given: Given, where: Where, language: Language, entry: str | None, color: str
) -> "Simulated":
    from vrts.cli.shared.requests import run_request_beside
    from vrts.run_files.simulated import simulate

    request = run_request_beside(given, where, language, entry)
    _say_where(request.setting, where, given)
    found = simulate(request)
    scenario = request.setting.scenario
    warnings = () if scenario is None else scenario.warnings
    show_diagnostics((*warnings, *found.diagnostics), color)
    return found


def _say_where(setting: "Setting", where: Where, given: Given) -> None:
    """Say what nobody asked for by name: the task beside the program, or a robot without a tool."""
    if where.scene is not None or where.task is not None:
        return
    if setting.task is not None:
        whose = "the task beside the program" if task_is_beside(given.path) else "that task"
        say(f"in the scene `{setting.scene.name}`, as {whose} has it")
    else:
        arm = setting.scene.robot.arm.title
        say(f"no scene: a bare {arm} with no tool; `--scene NAME` or a `task.toml` beside it")


def _loaded(given: Given, color: str) -> "Simulated":
    from vrts.run_files.loading import load_run

    found = load_run(*given.program, given.folder)
    show_diagnostics(found.diagnostics, color)
    return found


def _write_files(
    found: "Simulated", run: "Run", save: Path | None, table: str | None, rate: float
) -> None:
    if save is not None:
        from vrts.run_files.saving import saved_bytes

        write_file(save, saved_bytes(found))
        say(f"wrote {save}")
    if table is not None:
        from vrts.report.formats.run_csv import run_csv

        write_file(Path(table), "".join(run_csv(run, rate)).encode())
        if table != STDOUT:
            say(f"wrote {table}")


def _check(found: "Simulated", name: str, color: str) -> None:
    from vrts.run_files.loading import check_again

    different = check_again(found)
    if different is not None:
        show_diagnostics((different,), color)
        sys.exit(WRONG)
    say(f"{name} holds: executed again, everything is the same")


def _show_state(run: "Run", time_s: float | None, statement: int | None) -> None:
    from vrts.report.screen.state_text import state_text

    if time_s is not None:
        state = run.at(_inside(run, time_s))
    else:
        assert statement is not None
        if not 0 <= statement <= run.statements:
            fail(f"the run has {run.statements:,} statements")
        state = run.at_statement(statement)
    out(state_text(run, state))


def _inside(run: "Run", time_s: float) -> float:
    """Return a time of the run; its end may be given rounded, as it is printed."""
    if not 0.0 <= time_s <= run.horizon_s + ROUNDED_S:
        fail(f"the run goes from 0 to {run.horizon_s:.3f} s")
    return min(time_s, run.horizon_s)


def _span(run: "Run", from_s: float | None, to_s: float | None, speed: float | None) -> _Span:
    """Return what to tell; a negative speed goes from the later time to the earlier."""
    backward = speed is not None and speed < 0.0
    begin = _inside(run, from_s if from_s is not None else run.horizon_s if backward else 0.0)
    end = _inside(run, to_s if to_s is not None else 0.0 if backward else run.horizon_s)
    if backward and begin < end:
        begin, end = end, begin
    if speed is not None and speed > 0.0 and begin > end:
        fail("from the later time to the earlier goes backward", ("give a negative --speed",))
    if speed is None:
        speed = 1.0 if sys.stdout.isatty() else 0.0
    return _Span(begin, end, speed)


def _replay(run: "Run", span: _Span) -> None:
    from vrts.cli.shared.pacing import show_paced
    from vrts.report.screen.replay_text import replay

    lines = replay(run, span.from_s, span.to_s)
    show_paced(lines, span.from_s, span.speed, out, time.monotonic, time.sleep)


def _show_output(run: "Run") -> None:
    from vrts.report.plain import plain_text

    out(plain_text(run.output.replace("\r\n", "\n")), end=False)
    ended = run.ended_s if run.ended_s is not None else run.horizon_s
    say(f"{run.ending.value} after {ended:.3f} s of simulated time")
