"""`vrts dispatch plan`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    WRONG,
    guarded,
    say,
    show_diagnostics,
    warn,
    write_file,
)
from vrts.cli.shared.one_program import of_one_program
from vrts.cli.shared.options import (
    Language,
    color_option,
    controller_option,
    dialect_option,
    file_option,
    jobs_option,
    lab_option,
    placed,
    with_option,
)
from vrts.cli.shared.programs import given_program, no_setting, tell_task
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from vrts.pipeline.setting import Setting

EPILOG = """\b
Examples:
  vrts dispatch plan examples/01-cans-on-bases/solution.v2 --profile mark2-val2 -o cans.bundle
  vrts dispatch plan prog.v2 --scene cans-on-bases --profile mark2-val2 -o prog.bundle
  vrts dispatch plan prog.v2 --lab lab.toml --scenario part-there.toml --scenario no-part.toml \\
      --profile mark2-val2 -o prog.bundle
  vrts dispatch plan prog.v2 --profile mark2-val2 -o prog.bundle \\
      --waive V812-3f2a9c --reason "guard measured, 8 mm are enough" --who "R. Huber"
"""


@click.command(name="plan", epilog=EPILOG)
@of_one_program("Name or path of a scene; without it the task's.", packed=True)
@file_option(
    "--scenario",
    "scenarios",
    multiple=True,
    help="A scenario file; you may give several. Without it the one beside the task, or none.",
)
@click.option(
    "--profile",
    "profile_name",
    required=True,
    metavar="NAME",
    help="The controller: mark2-val2, mark3-val2, vplus-serial, kawasaki-as, or a file NAME.toml.",
)
@file_option("-o", "--output", "target", required=True, help="The bundle to write.")
@file_option("--sheet", help="Write the operator's sheet, too.")
@click.option(
    "--clearance",
    "clearance_mm",
    type=click.FloatRange(1.0, 100.0),
    default=10.0,
    show_default=True,
    metavar="MM",
    help="Distance to keep from everything.",
)
@file_option(
    "--environment",
    "environment_file",
    help="What may come from outside; without it as the task says, or any input at any time.",
)
@click.option("--entry", help="Program to execute; without it the task's, else the main one.")
@click.option(
    "--waive",
    "findings",
    multiple=True,
    metavar="FINDING",
    help="Waive a refusal: go on in spite of it. Give its name, such as V812-3f2a9c.",
)
@click.option("--reason", "reasons", multiple=True, metavar="TEXT", help="Why; one reason each.")
@click.option("--who", "people", multiple=True, metavar="NAME", help="Who waives it.")
@click.option(
    "--fails-first", is_flag=True, help="Find the margin that fails first; this takes longest."
)
@jobs_option("Processes at a time; without it one per core.")
@with_option("Send the programs of FILE, too.")
@dialect_option("Dialect of the program.", default="val2")
@lab_option
@controller_option
@color_option
@guarded
@placed
def command(
    program: str,
    where: Where,
    scenarios: tuple[Path, ...],
    profile_name: str,
    target: Path,
    sheet: Path | None,
    clearance_mm: float,
    environment_file: Path | None,
    entry: str | None,
    findings: tuple[str, ...],
    reasons: tuple[str, ...],
    people: tuple[str, ...],
    fails_first: bool,
    jobs: int | None,
    others: tuple[str, ...],
    dialect: str,
    color: str,
) -> None:
    """Verify PROGRAM for a real controller, and write a bundle to be sent.

    Everything that `vrts verify` checks has to hold, with the values as the controller prints them,
    and in every future: whatever inputs come, at every moment, at every EXECUTE. The program is
    verified again with objects 3 mm and the base 2 mm off, with other speeds and corners, at SPEED
    10, stopped in every tick, and raised for a dry run. What is not proven is refused.

    Each refusal has a name. With --waive, --reason and --who somebody can go on in spite of it; all
    of this is on the operator's sheet.

    The bundle holds programs and data as they are sent, a manifest with hashes, certificates of
    the runs, and the sheet. The same input gives the same bytes. Nothing is sent. Exit status 1
    when the program is refused.
    """
    from vrts.cli.shared.cores import one_thread_each, workers_of

    one_thread_each()
    from vrts.base.diagnostic import Diagnostic
    from vrts.cli.shared.requests import verify_request
    from vrts.dispatch.bundle import bundle_bytes, digest_of, read_bundle
    from vrts.dispatch.planning.plan import plan
    from vrts.dispatch.planning.reasons.futures import asked_of
    from vrts.dispatch.planning.reasons.refusals import promises_of
    from vrts.dispatch.planning.wish import Wish
    from vrts.dispatch.profile import find_profile
    from vrts.dispatch.proofs import check_proofs
    from vrts.pipeline.environments import environment_of
    from vrts.pipeline.files import read_toml_source
    from vrts.pipeline.refused import Refused

    promises = promises_of(findings, reasons, people)
    if isinstance(promises, Diagnostic):
        raise Refused((promises,))
    profile = find_profile(profile_name)
    given = given_program(program)
    first, *further = _settings(given.path, where, scenarios)
    request = verify_request(given, first, Language(others, dialect), entry=entry)
    environment = asked_of(first)
    source = None if environment_file is None else read_toml_source(environment_file)
    if source is not None:
        environment, said = environment_of(source, first)
        show_diagnostics(said, color)
    wish = Wish(
        request,
        profile,
        clearance_mm,
        promises,
        tuple(further),
        environment,
        fails_first,
        workers_of(jobs),
        source,
    )
    found = plan(wish)
    show_diagnostics(found.refused, color)
    if found.bundle is None:
        warn("refused: no bundle was written")
        sys.exit(WRONG)
    for finding in found.idle:
        say(f"note: the waiver of {finding} was not needed, and is not on the sheet")
    for waived in found.waived:
        say(f"waived: {waived.rule.code}: {waived.headline}")
    if profile.warning:
        say(f"note: {profile.warning}")
    written = bundle_bytes(found.bundle)
    check_proofs(read_bundle(written))  # what cannot be read again is no bundle
    write_file(target, written)
    say(f"wrote {target} (sha256 {digest_of(written)[:12]})")
    if sheet is not None:
        write_file(sheet, found.bundle.sheet.encode())
        say(f"wrote {sheet}, to be printed")
    if fails_first:
        say(f"first to fail: {found.bundle.manifest.first_to_fail}")
    sys.exit(HOLDS)


def _settings(
    path: Path | None, where: Where, scenarios: tuple[Path, ...]
) -> "tuple[Setting, ...]":
    """Return what to verify in, one setting for each scenario."""
    from vrts.assignments.packed import found_setting

    tell_task(path, where)
    places = [where._replace(scenario=scenario) for scenario in scenarios or (None,)]
    found = [found_setting(path, place) for place in places]
    settings = tuple(setting for setting in found if setting is not None)
    if not settings:
        no_setting(path, "to verify the program")
    return settings
