"""`vrts dispatch export`."""

import sys
from pathlib import Path

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
    Language,
    color_option,
    controller_option,
    entry_option,
    lab_option,
    language_options,
    placed,
    scenario_option,
    scene_option,
    task_option,
)
from vrts.cli.shared.programs import given_program
from vrts.pipeline.where import Where

EPILOG = """\b
Examples:
  vrts dispatch export solution.v2 --to vplus
  vrts dispatch export solution.v2 --to as -o solution.as
  vrts dispatch export prog.v2 --scene cans-on-bases --to as -o -
"""


@click.command(name="export", epilog=EPILOG)
@click.argument("program")
@click.option(
    "--to",
    "target",
    type=click.Choice(["val2", "vplus", "as"]),
    required=True,
    help="VAL-II, V+ of Adept and Staeubli, or AS of Kawasaki.",
)
@scene_option("Name or path of a scene to verify in.")
@task_option()
@scenario_option()
@entry_option("Program to execute; otherwise the task's, or the first.")
@click.option("-o", "--out", "place", help="File to write; `-` is stdout.")
@lab_option
@controller_option
@language_options
@color_option
@guarded
@placed
def command(
    program: str,
    target: str,
    where: Where,
    entry: str | None,
    place: str | None,
    language: Language,
    color: str,
) -> None:
    """Write PROGRAM, once verified, in the language of another controller.

    Words, angles and operators become those of the other language; comments and names stay. What
    is written is read again in that language and executed in the same scene: nothing is written
    unless it moves the arm the same within 0.01 mm at every time. Joint angles and READY stay
    those of the arm that was simulated.
    """
    from vrts.cli.shared.requests import verify_request
    from vrts.dispatch.posts.export import default_name, exported
    from vrts.dispatch.posts.same_motion import TOLERANCE_MM
    from vrts.pipeline.settings import setting_for

    given = given_program(program)
    path = given.path
    setting = setting_for(path, where)
    if setting is None:
        fail("nothing says in which scene to verify the program", ("give `--scene NAME`",))
    found = exported(verify_request(given, setting, language, entry=entry), target)
    show_diagnostics(found.diagnostics, color)
    if found.text is None:
        sys.exit(WRONG)
    assert found.difference is not None
    if place == "-" or (place is None and path is None):
        out(found.text, end=False)
    else:
        written = (
            default_name(path or Path(given.program.name), target) if place is None else Path(place)
        )
        if path is not None and written.resolve() == path.resolve():
            fail(f"`{place}` is the program itself", ("give another file to `-o`",))
        write_file(written, found.text.encode())
        say(f"wrote {written}")
    say(
        f"the same motion: largest difference {found.difference.most_mm:.4f} mm"
        f" of {TOLERANCE_MM:g} mm allowed"
    )
    sys.exit(HOLDS)
