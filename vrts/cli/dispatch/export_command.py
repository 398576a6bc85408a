"""`vrts dispatch export`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING, NoReturn

import click

from vrts.cli.shared.console import (
    HOLDS,
    STDOUT,
    WRONG,
    fail,
    say,
    show_diagnostics,
    write_file,
)
from vrts.cli.shared.mcap import NOT_INSTALLED
from vrts.cli.shared.one_program import executed_so
from vrts.cli.shared.options import (
    Language,
    entry_option,
    scenario_option,
    scene_option,
    task_option,
)
from vrts.cli.shared.programs import given_program, no_setting
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vrts.base.source import SourceFile
    from vrts.dispatch.linuxcnc.export import Folder as CncFolder
    from vrts.dispatch.posts.other_arm import OtherArm
    from vrts.dispatch.urscript.export import Folder as ScriptFolder
    from vrts.pipeline.request import Request

EPILOG = """\b
Examples:
  vrts dispatch export solution.v2 --to vplus
  vrts dispatch export solution.v2 --to as -o solution.as
  vrts dispatch export prog.v2 --scene cans-on-bases --to as --arm kawasaki.toml -o -
  vrts dispatch export solution.v2 --to linuxcnc -o folder
  vrts dispatch export solution.v2 --to ros -o folder
  vrts dispatch export prog.v2 --scene one-can-ur5 --to urscript -o folder
"""
VAL2, LINUXCNC, ROS, URSCRIPT = "val2", "linuxcnc", "ros", "urscript"


@click.command(name="export", epilog=EPILOG)
@click.argument("program")
@click.option(
    "--to",
    "target",
    type=click.Choice([VAL2, "vplus", "as", LINUXCNC, ROS, URSCRIPT]),
    required=True,
    help="VAL-II, V+ of Adept, AS of Kawasaki, G-code of LinuxCNC, ROS 2, or URScript.",
)
@scene_option("Name or path of a scene to verify in.")
@task_option()
@scenario_option()
@entry_option("Program to execute; without it the task's, or the first.")
@click.option(
    "-o", "--output", "place", help="File to write; for the last three a folder. `-` is stdout."
)
@click.option(
    "--arm",
    "arm_file",
    metavar="FILE|same",
    help="How the other arm counts its joints, for V+ and AS; `same`: as the simulated one.",
)
@executed_so
def command(
    program: str,
    target: str,
    where: Where,
    entry: str | None,
    place: str | None,
    arm_file: str | None,
    language: Language,
    color: str,
) -> None:
    """Verify PROGRAM, and write it in the language of another controller.

    Words, angles and operators become those of the other language; comments and names stay. The
    new text is read in that language and executed in the same scene. It is written only if it moves
    the arm the same within 0.01 mm at every time. TOOL and BASE are set where the program begins,
    and a sheet beside it says where HERE must show what. Another arm may count its joints in
    another way: joint values and READY are refused unless `--arm` says how.

    For LinuxCNC it writes a folder with the robot's configuration. `io.toml` in it says which pin
    is which signal; one that is there already stays. `vrts dispatch rehearse` then compares
    LinuxCNC's motion. For ROS it writes a folder with the run as a bag, and a goal of a joint
    trajectory controller for each way from rest to rest. For an arm of Universal Robots it writes a
    folder with the program in URScript, `io.toml` as above, and a sheet.
    """
    from vrts.cli.shared.requests import verify_request
    from vrts.dispatch.posts.export import default_name, default_sheet, exported
    from vrts.dispatch.posts.same_motion import TOLERANCE_MM
    from vrts.pipeline.settings import setting_for

    given = given_program(program)
    path = given.path
    setting = setting_for(path, where)
    if setting is None:
        no_setting(path, "to verify the program")
    if target == LINUXCNC:
        _linuxcnc(verify_request(given, setting, language, entry=entry), path, place, color)
    if target == ROS:
        _ros(verify_request(given, setting, language, entry=entry), path, place, color)
    if target == URSCRIPT:
        _urscript(verify_request(given, setting, language, entry=entry), path, place, color)
    arm = _arm(arm_file, target)
    found = exported(verify_request(given, setting, language, entry=entry), target, arm)
    show_diagnostics(found.diagnostics, color)
    if found.text is None:
        sys.exit(WRONG)
    assert found.difference is not None
    if place == STDOUT or (place is None and path is None):
        write_file(Path(STDOUT), found.text.encode())
    else:
        written = (
            default_name(path or Path(given.program.name), target) if place is None else Path(place)
        )
        if path is not None and written.resolve() == path.resolve():
            fail(f"`{place}` is the program itself", ("give another file to `-o`",))
        write_file(written, found.text.encode())
        say(f"wrote {written}")
        assert found.sheet is not None
        sheet = default_sheet(written)
        write_file(sheet, found.sheet.encode())
        say(f"wrote {sheet}: what is assumed, and where HERE must show what")
    say(
        f"the same motion: largest difference {found.difference.most_mm:.4f} mm"
        f" of {TOLERANCE_MM:g} mm allowed"
    )
    sys.exit(HOLDS)


def _arm(name: str | None, target: str) -> "OtherArm | None":
    """Return the arm that a text is for; VAL-II is taken to stay with the arm that it has."""
    from vrts.dispatch.posts.other_arm import SAME, read_arm
    from vrts.pipeline.files import read_toml_source

    if name is None:
        return SAME if target == VAL2 else None
    return SAME if name == "same" else read_arm(read_toml_source(Path(name)))


def _linuxcnc(request: "Request", path: Path | None, place: str | None, color: str) -> NoReturn:
    from vrts.dispatch.linuxcnc.export import exported_folder

    folder = _folder(request, path, place, LINUXCNC)
    _with_table(exported_folder(request, _table(folder)), folder, color)
    say(f"wrote {folder}: program.ngc, the robot's configuration, what is claimed in sheet.md")
    sys.exit(HOLDS)


def _urscript(request: "Request", path: Path | None, place: str | None, color: str) -> NoReturn:
    from vrts.dispatch.urscript.export import exported_script

    folder = _folder(request, path, place, URSCRIPT)
    _with_table(exported_script(request, _table(folder)), folder, color)
    say(f"wrote {folder}: program.script, not tried on a controller; read sheet.md")
    sys.exit(HOLDS)


def _table(folder: Path) -> "SourceFile | None":
    """Return the user's own table of signals, where there is one already."""
    from vrts.dispatch.saying.table import TABLE
    from vrts.pipeline.files import read_toml_source

    table = folder / TABLE
    return read_toml_source(table) if table.is_file() else None


def _with_table(found: "CncFolder | ScriptFolder", folder: Path, color: str) -> None:
    """Write what was exported; a table of signals that is there already stays."""
    from vrts.dispatch.saying.table import TABLE

    show_diagnostics(found.diagnostics, color)
    if found.files is None:
        sys.exit(WRONG)
    kept = (TABLE,) if (folder / TABLE).is_file() else ()
    _write(folder, {name: data for name, data in found.files.items() if name not in kept})


def _ros(request: "Request", path: Path | None, place: str | None, color: str) -> NoReturn:
    folder = _folder(request, path, place, ROS)
    try:
        from vrts.dispatch.ros_folder import exported_messages
    except ModuleNotFoundError:
        fail(NOT_INSTALLED, status=WRONG)
    found = exported_messages(request)
    show_diagnostics(found.diagnostics, color)
    if found.files is None:
        sys.exit(WRONG)
    _write(folder, found.files)
    say(f"wrote {folder}: the run in bag, goals of a controller, what is claimed in sheet.md")
    sys.exit(HOLDS)


def _folder(request: "Request", path: Path | None, place: str | None, target: str) -> Path:
    """Return the folder to write: the one that was given, or one beside the program."""
    if place == STDOUT:
        fail(f"a folder is written for {target}", ("give its name to `-o`",))
    stem = Path(request.program.name).stem if path is None else str(path.with_suffix(""))
    return Path(f"{stem}-{target}" if place is None else place)


def _write(folder: Path, files: "Mapping[str, bytes]") -> None:
    for name, data in files.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        write_file(file, data)
