"""`vrts check-proof`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import HOLDS, WRONG, fail, out, show_diagnostics
from vrts.cli.shared.one_program import executed_so
from vrts.cli.shared.options import (
    Language,
    file_option,
    scenario_option,
    scene_option,
    task_option,
)
from vrts.cli.shared.programs import given_program, no_setting
from vrts.pipeline.files import read_bytes, shown
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from vrts.run_files.simulated import Simulated

EPILOG = """\b
Examples:
  vrts check-proof run.cert
  vrts check-proof run.cert solution.v2
  vrts check-proof run.cert solution.v2 --task task.toml
  vrts check-proof run.cert solution.v2 --controller vplus
  vrts check-proof run.cert --run saved.vrun
"""


@click.command(name="check-proof", epilog=EPILOG)
@click.argument("certificate", type=click.Path(path_type=Path))
@click.argument("program", required=False)
@scene_option("Name or path of the scene that the program runs in.")
@task_option(packed=True)
@scenario_option()
@file_option("--run", help="A saved run (.vrun) that the certificate has to be about.")
@executed_so
def command(
    certificate: Path,
    program: str | None,
    where: Where,
    run: Path | None,
    language: Language,
    color: str,
) -> None:
    """Check a CERTIFICATE that `verify --certificate` wrote; it has to be about PROGRAM, if given.

    vrts executes the program in the certificate again, in its scene. A small checker that uses no
    distance library checks everything that the certificate claims. Exit status 1 when something is
    not proven, or when the certificate is about another program, scene, task, controller model or
    run than you give.
    """
    from vrts.pipeline.controllers import model_named
    from vrts.report.screen.proof_text import About, proof_text
    from vrts.run_files.proving import differing, proof_of, scenario_digest, under_another

    if program is None and any(where._replace(controller=None)):
        fail("a scene or a task is compared with the help of a program", ("give the program too",))
    data = read_bytes(certificate)
    # what cannot be read or found is told before anything is said to hold
    model = None
    if program is None and where.controller is not None:
        model = model_named(where.controller)
    others: list[Simulated] = []
    if program is not None:
        others.append(_simulated(program, where, language))
    if run is not None:
        others.append(_loaded(run))
    proof = proof_of(data, shown(certificate))
    assert proof.made.run is not None
    assert proof.made.origin is not None
    origin, made = proof.made.origin, proof.made.run
    hashed = scenario_digest(made, origin)
    about = About(proof.name, proof.size, made, origin, hashed)
    out(proof_text(about, proof.claims, proof.proven))
    if model is not None:
        found = under_another(proof, model)
        if found is not None:
            show_diagnostics((found,), color)
            sys.exit(WRONG)
    for other in others:
        found = differing(proof, other)
        if found is not None:
            show_diagnostics((found,), color)
            sys.exit(WRONG)
    sys.exit(HOLDS)


def _simulated(program: str, where: Where, language: Language) -> "Simulated":
    from vrts.assignments.packed import found_setting
    from vrts.cli.shared.requests import verify_request
    from vrts.run_files.simulated import simulate

    given = given_program(program)
    setting = found_setting(given.path, where)
    if setting is None:
        no_setting(given.path, "the program runs")
    return simulate(verify_request(given, setting, language))


def _loaded(run: Path) -> "Simulated":
    from vrts.run_files.loading import load_run

    return load_run(read_bytes(run), shown(run), run.parent)
