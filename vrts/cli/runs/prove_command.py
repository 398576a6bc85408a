"""`vrts prove`."""

import shlex
import sys
from collections.abc import Mapping
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    UNDETERMINED,
    WRONG,
    out,
    say,
    show_diagnostics,
    use_color,
    write_file,
)
from vrts.cli.shared.one_program import executed_so, of_one_program
from vrts.cli.shared.options import (
    Language,
    entry_option,
    file_option,
    form_option,
    jobs_option,
    no_collisions_option,
    scenario_option,
)
from vrts.cli.shared.programs import given_program
from vrts.cli.shared.searching import searching
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from vrts.pipeline.futures import Proved
    from vrts.pipeline.request import Request
    from vrts.prove.environment.environment import Environment
    from vrts.prove.proof import Proof, Wronged

MOST_LEAVES = 1_000  # of which scenarios are told
EPILOG = """\b
Examples:
  vrts prove examples/01-cans-on-bases/solution.v2
  vrts prove prog.v2 --scene cans-on-bases
  vrts prove prog.v2 --environment environment.toml
  vrts prove prog.v2 --counterexample bad.toml
  vrts prove prog.v2 --html page.html
  vrts prove prog.v2 --states 20000 --format json
"""


@click.command(name="prove", epilog=EPILOG)
@of_one_program("Name or path of a scene; without it the task's, or the robot alone.", packed=True)
@file_option("--environment", help="What may come from outside; see `vrts new environment`.")
@scenario_option("How every future begins, and what is the same in all: a scenario file.")
@file_option("--html", help="Write a page with the tree of decisions and replays.")
@file_option("--counterexample", help="Write the future that goes wrong as a scenario file.")
@click.option(
    "--states",
    type=click.IntRange(1, 100_000_000),
    help="Look at no more states than this.",
)
@click.option(
    "--seconds",
    type=click.FloatRange(0.1),
    help="Stop looking after this time, and say what is known by then.",
)
@jobs_option("Processes at a time; without it one per core. The answer is always the same.")
@entry_option("Program to execute; without it the task's, or the main one.")
@form_option("full", "json")
@no_collisions_option
@executed_so
def command(
    program: str,
    where: Where,
    environment: Path | None,
    html: Path | None,
    counterexample: Path | None,
    states: int | None,
    seconds: float | None,
    jobs: int | None,
    entry: str | None,
    form: str,
    no_collisions: bool,
    language: Language,
    color: str,
) -> None:
    """Look at every future of PROGRAM: all inputs, at every moment at which they matter.

    Whatever the program reads from outside may have any value, unless an environment says what may
    come. Exit status 1 when something can go wrong, 3 when not all futures could be looked at.
    """
    from vrts.cli.shared.cores import one_thread_each, workers_of

    one_thread_each()
    from vrts.api.requests import outside
    from vrts.assignments.packed import found_setting
    from vrts.cli.shared.requests import run_request, verify_request
    from vrts.pipeline.futures import proved
    from vrts.prove.asking import USUAL_STATES, Asking

    given = given_program(program)
    setting = found_setting(given.path, where)
    if setting is None:
        request = run_request(given, where, language, entry)
    else:
        request = verify_request(given, setting, language, entry=entry)
    # a scenario that is asked for is no example: what it says holds in every future
    around, said = outside(request.setting, environment, fixed=where.scenario is not None)
    show_diagnostics(said, color)
    workers = workers_of(jobs)
    with searching(seconds) as asked:
        asking = Asking(
            states=USUAL_STATES if states is None else states,
            collisions=not no_collisions,
            told=asked.told,
            enough=asked.enough,
            answers=workers.answers,
            beside=workers.beside,
        )
        found = proved(request, around, asking)
    show_diagnostics(found.diagnostics, color)
    if found.proof is None:
        sys.exit(WRONG)
    title = request.title or request.program.name
    if form == "json":
        from vrts.report.formats.futures_json import futures_json
        from vrts.report.formats.json_text import json_text

        texts = tuple(map(_scenario, found.proof.found))
        tick_s = request.setting.scene.robot.arm.tick
        leaves = _of_leaves(found.proof, around, tick_s)
        out(json_text(futures_json(title, found.proof, texts, leaves)))
    else:
        from vrts.report.screen.futures_text import futures_text

        out(futures_text(title, found.proof, color=use_color(color)))
    if html is not None:
        _write_page(request, found, around, html)
    if counterexample is not None:
        command = "run" if setting is None else "verify"
        again = ["vrts", command, str(program), *_named(where, language, entry), "--scenario"]
        _write(found.proof, again, counterexample)
    sys.exit(status_of(found.proof))


def _of_leaves(proof: "Proof", environment: "Environment", tick_s: float) -> Mapping[int, str]:
    """Return scenarios of the first leaves of the tree of decisions, by branch."""
    from vrts.prove.telling.leaves import leaves
    from vrts.prove.telling.scenarios import scenario_of
    from vrts.scene.writing.scenario_text import scenario_text

    return {
        number: scenario_text(
            f"future {number}: {proof.tree[number].ends}",
            scenario_of(environment, story, tick_s),
        )
        for number, story in islice(leaves(proof.tree), MOST_LEAVES)
    }


def _write_page(
    request: "Request", found: "Proved", environment: "Environment", path: Path
) -> None:
    """Write the page about every future, and say so."""
    from vrts.pipeline.futures import leaf_replays, replays
    from vrts.report.page.future_cards import MOST_FOUND
    from vrts.report.page.futures.folding import nodes, scenarios_of
    from vrts.report.page.futures.whole import MOST_WATCHED, Explored, futures_page

    assert found.proof is not None
    scene, task = request.setting.scene, request.setting.task
    drawn, tick_s = nodes(found.proof), scene.robot.arm.tick
    explored = Explored(
        request.title or request.program.name,
        f"{task.title} · scene {scene.name}" if task else f"scene {scene.name}",
        found.compiled.source,
        found.proof,
        environment,
        tick_s,
        replays(request, found, MOST_FOUND),
        leaf_replays(request, found, scenarios_of(drawn, environment, tick_s), MOST_WATCHED),
    )
    write_file(path, futures_page(explored).encode())
    say(f"wrote {path}")


def _named(where: Where, language: Language, entry: str | None) -> list[str]:
    """Return the options that name the same setting again."""
    given = (
        ("--scene", where.scene),
        ("--task", where.task),
        ("--lab", where.lab),
        ("--controller", where.controller),
        ("--dialect", language.dialect),
        *(("--with", other) for other in language.others),
        ("--entry", entry),
    )
    return [str(word) for pair in given if pair[1] is not None for word in pair]


def _write(proof: "Proof", again: list[str], path: Path) -> None:
    """Write the shortest counterexample as a scenario, if there is one, and say how to see it."""
    if not proof.found:
        say("nothing goes wrong in any future that was looked at, so no scenario is written")
        return
    write_file(path, _scenario(proof.found[0]).encode())
    say(f"wrote {path}; see it with `{shlex.join([*again, str(path)])}`")


def _scenario(wronged: "Wronged") -> str:
    from vrts.api.proofs import scenario_of

    return scenario_of(wronged)


def status_of(proof: "Proof") -> int:
    """Return the exit status of a proof."""
    from vrts.check.verdict import Answer

    status = {Answer.HOLDS: HOLDS, Answer.VIOLATED: WRONG, Answer.UNDETERMINED: UNDETERMINED}
    return status[proof.answer]
