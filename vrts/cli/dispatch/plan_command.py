"""`vrts dispatch plan`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    color_option,
    fail,
    guarded,
    lab_option,
    program_bytes,
    say,
    show_diagnostics,
    write_file,
)

if TYPE_CHECKING:
    from vrts.pipeline.settings import Setting

EPILOG = """\b
Examples:
  vrts dispatch plan examples/01-cans-on-bases/solution.v2 --profile mark2-val2 -o cans.bundle
  vrts dispatch plan prog.v2 --scene cans-on-bases --profile mark2-val2 -o prog.bundle
  vrts dispatch plan prog.v2 --lab lab.toml --scenario part-there.toml --scenario no-part.toml \\
      --profile mark2-val2 -o prog.bundle
  vrts dispatch plan prog.v2 --profile mark2-val2 -o prog.bundle \\
      --waive V812 --reason "guard measured, 8 mm are enough" --who "R. Huber"
"""


@click.command(name="plan", epilog=EPILOG)
@click.argument("program")
@click.option("--scene", help="Name or path of a scene; without it the task's.")
@click.option("--task", type=click.Path(path_type=Path), help="Task file, its folder, or a zip.")
@click.option(
    "--scenario",
    "scenarios",
    type=click.Path(path_type=Path),
    multiple=True,
    help="What happens in a run; several add up. Without it the one beside the task, or none.",
)
@click.option(
    "--profile",
    "profile_name",
    required=True,
    metavar="NAME",
    help="The controller: mark2-val2, mark3-val2, vplus-serial, kawasaki-as, or a file NAME.toml.",
)
@click.option(
    "-o", "--out", "target", type=click.Path(path_type=Path), required=True, help="The bundle."
)
@click.option("--sheet", type=click.Path(path_type=Path), help="Write the operator's sheet, too.")
@click.option(
    "--clearance",
    "clearance_mm",
    type=click.FloatRange(1.0, 100.0),
    default=10.0,
    show_default=True,
    metavar="MM",
    help="Distance to keep from everything.",
)
@click.option("--entry", help="Program to execute; without it the task's, else the first.")
@click.option("--waive", "codes", multiple=True, metavar="CODE", help="Answer for a refusal.")
@click.option("--reason", "reasons", multiple=True, metavar="TEXT", help="Why; one for each.")
@click.option("--who", "people", multiple=True, metavar="NAME", help="Who answers for it.")
@click.option(
    "--with", "others", metavar="FILE", multiple=True, help="Send the programs of FILE, too."
)
@click.option(
    "--dialect",
    type=click.Choice(["auto", "val2", "val2+", "val", "vplus", "as"]),
    default="val2",
    show_default=True,
    help="Language that the program is written in.",
)
@lab_option
@color_option
@guarded
def command(
    program: str,
    scene: str | None,
    task: Path | None,
    scenarios: tuple[Path, ...],
    profile_name: str,
    target: Path,
    sheet: Path | None,
    clearance_mm: float,
    entry: str | None,
    codes: tuple[str, ...],
    reasons: tuple[str, ...],
    people: tuple[str, ...],
    others: tuple[str, ...],
    dialect: str,
    lab: Path | None,
    color: str,
) -> None:
    """Verify PROGRAM for a real controller, and write a bundle to be sent.

    Everything that `vrts verify` looks at has to hold, with the values as the controller prints
    them; every step that moves has to be executed in some scenario, and every decision that
    depends on an input has to be taken both ways. It is verified again with objects 3 mm and the
    base 2 mm off, with other speeds, at SPEED 10, and raised for a dry run. What is not proven is
    refused; a refusal is waived with its code, a reason and a name, all of which stand on the
    operator's sheet.

    The bundle holds programs and data as they are sent, a manifest with hashes, and the sheet; the
    same input gives the same bytes. Nothing is sent. Exit status 1 when it is refused.
    """
    from vrts.base.diagnostic import Diagnostic
    from vrts.cli.shared.console import reading_of
    from vrts.dispatch.bundle import bundle_bytes, digest_of, read_bundle
    from vrts.dispatch.planning.plan import Request, plan
    from vrts.dispatch.planning.reasons.refusals import promises_of
    from vrts.dispatch.profile import find_profile
    from vrts.pipeline.settings import Refused

    promises = promises_of(codes, reasons, people)
    if isinstance(promises, Diagnostic):
        raise Refused((promises,))
    profile = find_profile(profile_name)
    data, name, path = program_bytes(program)
    settings = _settings(path, scene, task, scenarios, lab)
    reading = reading_of(others, dialect, None, replace=False)
    request = Request(data, name, settings, profile, clearance_mm, promises, reading, entry)
    found = plan(request)
    show_diagnostics(found.refused, color)
    if found.bundle is None:
        say("refused: no bundle was written")
        sys.exit(WRONG)
    for code in found.idle:
        say(f"note: the waiver of {code} was not needed, and is not on the sheet")
    for waived in found.waived:
        say(f"waived: {waived.rule.code}: {waived.headline}")
    if profile.warning:
        say(f"note: {profile.warning}")
    written = bundle_bytes(found.bundle)
    read_bundle(written)  # what cannot be read again is no bundle
    write_file(target, written)
    say(f"wrote {target} (sha256 {digest_of(written)[:12]})")
    if sheet is not None:
        write_file(sheet, found.bundle.sheet.encode())
        say(f"wrote {sheet}, to be printed")
    say(f"first to fail: {found.bundle.manifest.first_to_fail}")
    sys.exit(HOLDS)


def _settings(
    path: Path | None,
    scene: str | None,
    task: Path | None,
    scenarios: tuple[Path, ...],
    lab: Path | None,
) -> "tuple[Setting, ...]":
    """Return what to verify in, one setting for each scenario."""
    from vrts.assignments.packed import is_packed, load_zip
    from vrts.pipeline.settings import setting_for

    found: list[Setting | None] = []
    for scenario in scenarios or (None,):
        if task is not None and is_packed(task):
            found.append(load_zip(task, scene=scene, scenario=scenario, staff=False, lab=lab))
        else:
            found.append(setting_for(path, scene=scene, task=task, scenario=scenario, lab=lab))
    settings = tuple(setting for setting in found if setting is not None)
    if not settings:
        fail(
            "nothing says in which scene to verify the program: there is no task.toml beside it",
            ("give `--scene NAME` or `--task FILE`",),
        )
    return settings
