"""`vrts view`."""

import shutil
import subprocess
import sys
import tempfile
import webbrowser
from pathlib import Path

import click

from vrts.cli.console import HOLDS, WRONG, color_option, guarded, say, show_diagnostics
from vrts.cli.verify_command import write_page, write_record

EPILOG = """\b
Examples:
  vrts view prog.v2
  vrts view prog.v2 --scene cans-on-bases
  vrts view prog.v2 --with rerun
  vrts view prog.v2 --still 6.4 -o moment.png
"""


@click.command(name="view", epilog=EPILOG)
@click.argument("program", type=click.Path(path_type=Path))
@click.option("--scene", help="Name or path of a scene; without it the task's, or the robot alone.")
@click.option("--task", type=click.Path(path_type=Path), help="Task file, or its folder.")
@click.option("--with", "viewer", type=click.Choice(["browser", "rerun"]), default="browser")
@click.option("--still", type=float, help="Draw one moment, in s, as a PNG picture instead.")
@click.option("-o", "--out", "target", type=click.Path(path_type=Path), help="File to write.")
@click.option("--no-open", is_flag=True, help="Write the file, but open nothing.")
@color_option
@guarded
def command(
    program: Path,
    scene: str | None,
    task: Path | None,
    viewer: str,
    still: float | None,
    target: Path | None,
    no_open: bool,
    color: str,
) -> None:
    """See PROGRAM move: as a page with a replay, or in the Rerun viewer."""
    from vrts.pipeline.assess import assess
    from vrts.pipeline.settings import robot_alone, setting_for

    setting = setting_for(program, scene=scene, task=task) or robot_alone()
    found = assess(program, setting=setting, curve=still is None)
    if found.run is None:
        show_diagnostics(found.findings, color)
        sys.exit(WRONG)
    if still is not None:
        from vrts.cli.console import fail, write_file
        from vrts.report.picture import picture_at

        if not 0 <= still <= found.run.horizon_s:
            fail(f"the run ends at {found.run.horizon_s:.3f} s")
        target = target or Path(f"{program.stem}.png")
        write_file(target, picture_at(found, still))
        say(f"wrote {target}")
        sys.exit(HOLDS)
    suffix = ".rrd" if viewer == "rerun" else ".html"
    path = target or Path(tempfile.mkdtemp(prefix="vrts-")) / f"{program.stem}{suffix}"
    if viewer == "rerun":
        write_record(found, path)
    else:
        write_page(found, path)
    if not no_open:
        _open(path, viewer)
    sys.exit(HOLDS)


def _open(path: Path, viewer: str) -> None:
    if viewer == "browser":
        if not webbrowser.open(path.resolve().as_uri()):
            say("no browser found here: open the file on another machine")
        return
    program = shutil.which("rerun", path=str(Path(sys.executable).parent)) or shutil.which("rerun")
    if program is None:
        say("the Rerun viewer is not installed here")
        return
    subprocess.run([program, str(path)], check=False)  # noqa: S603 -- our own file
