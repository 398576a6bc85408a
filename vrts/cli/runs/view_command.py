"""`vrts view`."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    STDOUT,
    WRONG,
    fail,
    guarded,
    say,
    show_diagnostics,
    write_file,
)
from vrts.cli.shared.options import (
    TASK_OR_ALONE,
    color_option,
    controller_option,
    file_option,
    no_open_option,
    placed,
    scene_option,
    task_option,
)
from vrts.cli.shared.programs import tell_task
from vrts.cli.shared.run_page import AGAIN, assessed, open_page, write_page
from vrts.pipeline.where import ANYWHERE, Where

if TYPE_CHECKING:
    from vrts.report.assessment import Assessment

RECORDING, RUN = ".rrd", ".vrun"
MAGIC = b"RRF"  # how recordings begin
EPILOG = """\b
Examples:
  vrts view prog.v2
  vrts view prog.v2 --scene cans-on-bases
  vrts view prog.v2 --viewer rerun
  vrts view prog.v2 --still 6.4 -o moment.png
  vrts view out.vrun
  vrts view run.rrd
"""


@click.command(name="view", epilog=EPILOG)
@click.argument("program", metavar="FILE", type=click.Path(path_type=Path))
@scene_option(TASK_OR_ALONE)
@task_option()
@controller_option
@click.option("--viewer", type=click.Choice(["browser", "rerun"]), default="browser")
@click.option("--at", "time_s", type=click.FloatRange(0.0), help="Open it at this time [s].")
@click.option(
    "--still", type=float, help="Draw the moment at this time [s] as a PNG picture instead."
)
@file_option("-o", "--output", "target", help="File to write.")
@no_open_option("Write the file (see -o), but open nothing.")
@color_option
@guarded
@placed
def command(
    program: Path,
    where: Where,
    viewer: str,
    time_s: float | None,
    still: float | None,
    target: Path | None,
    no_open: bool,
    color: str,
) -> None:
    """See FILE move: as a page with a replay, or in the Rerun viewer.

    FILE is a program, a run that `vrts run --save` has written (.vrun), or a recording (.rrd),
    which the Rerun viewer shows as it is.
    """
    file = program
    if file.suffix in (RECORDING, RUN) and where != ANYWHERE:
        fail(f"the scene of `{file.name}` is in it", ("leave out `--scene` and `--task`",))
    if time_s is not None and (still is not None or viewer == "rerun" or file.suffix == RECORDING):
        fail("`--at` is for the page: `--still` draws a moment of its own")
    if file.suffix == RECORDING:
        if still is not None or target is not None:
            fail(f"`{file.name}` is a recording already", ("give the program or its .vrun",))
        _check_recording(file)
        if not no_open:
            _open(file, "rerun")
        sys.exit(HOLDS)
    if str(target) == STDOUT:
        if viewer == "rerun" and still is None:
            fail("`--output` wants a name, not `-`", ("a recording is written in pieces",))
        no_open = True  # nobody opens what went to stdout
    found = _of_run(file) if file.suffix == RUN else _of_program(file, where, still is None)
    if found.run is None:
        show_diagnostics(found.findings, color)
        sys.exit(WRONG)
    if still is not None:
        _draw(found, still, target or Path(f"{file.stem}.png"))
    else:
        _show(found, viewer, target, time_s, no_open=no_open)
    sys.exit(HOLDS)


def _of_program(file: Path, where: Where, curve: bool) -> "Assessment":
    from vrts.pipeline.alone import robot_alone
    from vrts.pipeline.assess import assess
    from vrts.pipeline.controllers import with_controller
    from vrts.pipeline.request import Checks
    from vrts.pipeline.requesting import request_for
    from vrts.pipeline.settings import setting_for

    tell_task(file, where)
    setting = setting_for(file, where) or with_controller(robot_alone(), where.controller)
    return assess(request_for(file, setting=setting, checks=Checks(curve=curve, causes=True)))


def _of_run(file: Path) -> "Assessment":
    """Return what is known of a saved run, checked again without its task."""
    from vrts.pipeline.files import read_bytes, shown
    from vrts.run_files.loading import load_run

    run = load_run(read_bytes(file), shown(file), file.parent).run
    assert run is not None
    return assessed(file.stem, file.name, run)


def _check_recording(file: Path) -> None:
    from vrts.pipeline.files import CannotRead

    try:
        with file.open("rb") as stream:
            begin = stream.read(len(MAGIC))
    except OSError as problem:
        raise CannotRead(
            f"cannot read `{file}`: {(problem.strerror or 'failed').lower()}"
        ) from None
    if begin != MAGIC:
        fail(f"`{file}` is no Rerun recording", ("`vrts verify PROGRAM --record FILE` writes one",))


def _draw(found: "Assessment", time_s: float, target: Path) -> None:
    from vrts.report.picture.moments import picture_at

    assert found.run is not None
    if not 0 <= time_s <= found.run.horizon_s:
        fail(f"the run ends at {found.run.horizon_s:.3f} s")
    write_file(target, picture_at(found, time_s))
    say(f"wrote {target}")


def _show(
    found: "Assessment", viewer: str, target: Path | None, time_s: float | None, *, no_open: bool
) -> None:
    """Write a file, beside where we are or where nobody looks for it, and open it."""
    name = f"{found.identifier}{RECORDING if viewer == 'rerun' else '.html'}"
    if target is None and no_open:
        target = Path(name)
    path = target or Path(tempfile.mkdtemp(prefix="vrts-")) / name
    if viewer == "rerun":
        from vrts.report.recording import write_recording

        write_recording(found, path)
    else:
        write_page(found, path)
    if target is not None:
        from vrts.debug.marks.links import anchor

        at = "" if time_s is None else f"; `{anchor(time_s)}` behind its address is the time"
        say(f"wrote {target}{at}")
    if not no_open:
        _open(path, viewer, time_s)


def _open(path: Path, viewer: str, time_s: float | None = None) -> None:
    if viewer == "browser":
        open_page(path, time_s)
        return
    program = shutil.which("rerun", path=str(Path(sys.executable).parent)) or shutil.which("rerun")
    if program is None:
        fail("the Rerun viewer is not installed here", (AGAIN,), status=WRONG)
    ended = subprocess.run(  # noqa: S603 -- our own file
        [program, "--bind", "127.0.0.1", "--port", "auto", str(path)],
        stderr=subprocess.DEVNULL,
        check=False,
    )
    if ended.returncode:
        fail("the Rerun viewer could not show it; it needs a display", (AGAIN,), status=WRONG)
