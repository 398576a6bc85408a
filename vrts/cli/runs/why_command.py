"""`vrts why`."""

import sys

import click

from vrts.cli.shared.console import HOLDS, WRONG, fail, out, use_color
from vrts.cli.shared.one_program import executed_so, of_one_program
from vrts.cli.shared.options import (
    Language,
    form_option,
    scenario_option,
)
from vrts.cli.shared.programs import given_program, no_setting
from vrts.pipeline.where import Where

EPILOG = """\b
Examples:
  vrts why examples/04-final-project/submissions/loop-variable-lost.v2
  vrts why prog.v2 --at 6.2
  vrts why prog.v2 --of can2
  vrts why prog.v2 --of 'p[1]' --at 6.2
  vrts why prog.v2 --format json
"""


@click.command(name="why", epilog=EPILOG)
@of_one_program("Name or path of a scene: ask in it, without a mark.", packed=True)
@scenario_option()
@click.option("--at", "time_s", type=float, help="Why the arm does what it does at this time [s].")
@click.option("--of", "name", help="Why a thing is where it is, or why a variable has its value.")
@click.option(
    "--for",
    "reader",
    type=click.Choice(["student", "grader"]),
    default="student",
    help="Who asks: a student learns no more than the [hints] of the task allow.",
)
@form_option("full", "json")
@executed_so
def command(
    program: str,
    where: Where,
    time_s: float | None,
    name: str | None,
    reader: str,
    form: str,
    language: Language,
    color: str,
) -> None:
    """Say why points are lost, with the causes back to the step that is to blame.

    It explains all losses, or what you ask for: a time, a thing of the scene or a variable. A chain
    of causes has at most five lines, and what came last comes first. Exit status 1 when something
    is wrong.
    """
    from vrts.api.causes import chains_of
    from vrts.api.errors import VrtsError
    from vrts.assignments.packed import found_setting
    from vrts.cli.runs.verify_command import status_of
    from vrts.cli.shared.requests import verify_request
    from vrts.pipeline.assess import assess
    from vrts.pipeline.request import Checks
    from vrts.report.audience import Audience
    from vrts.report.because import told_to
    from vrts.report.formats.json_text import json_text
    from vrts.report.formats.why_json import chains_json
    from vrts.report.screen.causes.why_text import why_text

    given = given_program(program)
    setting = found_setting(given.path, where)
    if setting is None:
        no_setting(given.path, "to ask")
    found = assess(verify_request(given, setting, language, checks=Checks(causes=True)))
    level = told_to(found, Audience(reader))
    try:
        chains, whole = chains_of(found, name, time_s)
    except VrtsError as problem:
        hints = () if name is None else ("`vrts scene show` lists the things of a scene",)
        fail(str(problem), hints, status=WRONG)
    if form == "json":
        out(json_text(chains_json(found, chains, level)))
    else:
        out(why_text(found, chains, level, whole=whole, color=use_color(color)))
    sys.exit(status_of(found) if whole else HOLDS)
