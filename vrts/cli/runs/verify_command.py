"""`vrts verify`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    UNDETERMINED,
    WRONG,
    fail,
    out,
    say,
    show_diagnostics,
    use_color,
    warn,
    write_file,
)
from vrts.cli.shared.mcap import write_mcap
from vrts.cli.shared.one_program import executed_so, of_one_program
from vrts.cli.shared.options import (
    Language,
    engine_option,
    entry_option,
    file_option,
    form_option,
    no_collisions_option,
    scenario_option,
)
from vrts.cli.shared.programs import given_program, no_setting
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from vrts.api.assessments import Assessment as Whole
    from vrts.report.assessment import Assessment

NO_RERUN = (
    "recordings need the package rerun-sdk, which has no wheel for this machine;"
    " everything else works without it"
)

EPILOG = """\b
Examples:
  vrts verify examples/01-cans-on-bases/solution.v2
  vrts verify prog.v2 --scene cans-on-bases
  vrts verify prog.v2 --task task.toml --html page.html --record run.rrd
  vrts verify prog.v2 --task lab1-student.zip
  vrts verify prog.v2 --scenario gripper-slips.toml
  vrts verify prog.v2 --lab lab.toml
  vrts verify prog.v2 --entry unload
  vrts verify prog.v2 --engine fcl
  vrts verify prog.v2 --certificate run.cert
  vrts verify prog.v2 --format json
"""


@click.command(name="verify", epilog=EPILOG)
@of_one_program("Name or path of a scene: verify in it, without a mark.", packed=True)
@scenario_option()
@entry_option("Program to execute; without it the task's, or the main one.")
@file_option("--html", help="Write a page with a replay.")
@click.option(
    "--for",
    "reader",
    type=click.Choice(["student", "grader"]),
    default="student",
    help="Who reads the page: a grader's page shows what to review, and facts for an appeal.",
)
@file_option("--record", help="Write a Rerun recording (.rrd).")
@file_option("--mcap", help="Write the run as messages of ROS 2, for Foxglove and PlotJuggler.")
@file_option("--certificate", help="Write a certificate of the collision check, for `check-proof`.")
@form_option("full", "json")
@no_collisions_option
@engine_option("Library that looks for the nearest parts; no answer depends on it.")
@executed_so
def command(
    program: str,
    where: Where,
    entry: str | None,
    html: Path | None,
    reader: str,
    record: Path | None,
    mcap: Path | None,
    certificate: Path | None,
    form: str,
    no_collisions: bool,
    engine: str | None,
    language: Language,
    color: str,
) -> None:
    """Run PROGRAM and check everything: collisions, limits, goals.

    It takes the task.toml beside the program unless you give a scene or a task, and the
    scenario.toml beside the task unless you give a scenario. Exit status 1 when something is wrong,
    3 when a check cannot tell.
    """
    from vrts.cli.shared.cores import one_thread_each, workers_of

    one_thread_each()
    from vrts.api.verifying import assessed
    from vrts.assignments.packed import found_setting, public_answer
    from vrts.cli.shared.requests import verify_request
    from vrts.marking.proposer.by_name import by_name
    from vrts.pipeline.request import Checks

    if certificate is not None and no_collisions:
        fail("a certificate is of the check of collisions", ("leave out `--no-collisions`",))
    given = given_program(program)
    setting = found_setting(given.path, where)
    if setting is None:
        no_setting(given.path, "to verify the program")
    wanted = None if setting.task is None else setting.task.program
    if entry is not None and wanted is not None and entry.lower() != wanted.lower():
        warn(f"the task asks for the program `{wanted}`: this is the mark of `{entry}`")
    if where.scenario is not None and setting.scenario is not None:
        show_diagnostics(setting.scenario.warnings, color)
    with by_name(engine, asked=not no_collisions) as by:
        checks = Checks(
            collisions=not no_collisions,
            proposer=by.proposer,
            second=by.second,
            curve=html is not None or record is not None,
            causes=True,
            workers=workers_of(None),
        )
        request = verify_request(given, setting, language, entry=entry, checks=checks)
        whole = assessed(request)
        found = whole.inner
    if form == "json":
        from vrts.report.formats.json_form import assessment_json
        from vrts.report.formats.json_text import json_text

        out(json_text(assessment_json(found)))
    else:
        from vrts.report.screen.assessment_text import assessment_text

        out(assessment_text(found, color=use_color(color)))
        answer = public_answer(found.grade.ready, setting) if found.grade else None
        if answer is not None:
            out(f"\n{answer}")
    if html is not None:
        write_page(found, html, reader, setting.more)
    if record is not None:
        write_record(found, record)
    if mcap is not None:
        write_mcap(found, mcap)
    if certificate is not None:
        write_certificate(whole, certificate)
    sys.exit(status_of(found))


def write_certificate(found: "Whole", path: Path) -> None:
    """Write what proves that the collisions found are those there are, and say so."""
    from vrts.api.certificates import certified
    from vrts.api.errors import VrtsError

    try:
        data = certified(found.inner, found.simulated)
    except VrtsError as problem:
        warn(str(problem))
        return
    write_file(path, data)
    say(f"wrote {path}")


def write_page(found: "Assessment", path: Path, reader: str = "student", more: int = 0) -> None:
    """Write the HTML page for a reader and say so; `more` checks there will be at marking."""
    from vrts.report.audience import Audience
    from vrts.report.page.page import page
    from vrts.report.page.stills import page_stills

    text = page(found, page_stills(found), audience=Audience(reader), more=more)
    write_file(path, text.encode())
    say(f"wrote {path}")


def write_record(found: "Assessment", path: Path) -> None:
    """Write the recording and say so."""
    if found.run is None:
        warn("nothing ran, so there is nothing to record")
        return
    try:
        from vrts.report.recording import write_recording
    except ImportError:
        fail(NO_RERUN, status=WRONG)
    write_recording(found, path)
    say(f"wrote {path}")


def status_of(found: "Assessment") -> int:
    """Return the exit status of an assessment."""
    from vrts.check.verdict import Answer

    if found.judgement is None or any(d.is_error for d in found.findings):
        return WRONG
    return {Answer.HOLDS: HOLDS, Answer.VIOLATED: WRONG, Answer.UNDETERMINED: UNDETERMINED}[
        found.judgement.answer
    ]
