"""A program on its way to a real controller: verified as the controller will hold it, or refused.

What is verified in the end is the text of the bundle, read again; the program's own file is only
where it comes from, and where refusals point to.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Severity, error
from vrts.base.remembered import Memory
from vrts.base.units import MM
from vrts.check.judge import judge
from vrts.dispatch.bundle import Bundle
from vrts.dispatch.planning.asked import kept
from vrts.dispatch.planning.beside import margins
from vrts.dispatch.planning.beside.dry_run import NO_DRY_RUN, DryRun, dry_run
from vrts.dispatch.planning.beside.stops import stops
from vrts.dispatch.planning.beside.trials import BASE, OBJECTS, Subject
from vrts.dispatch.planning.beside.worlds import World
from vrts.dispatch.planning.making import Made, bundle_of
from vrts.dispatch.planning.printed import printed, read_back
from vrts.dispatch.planning.proving import Held, shown
from vrts.dispatch.planning.reasons import coverage, dependence, fits, futures
from vrts.dispatch.planning.reasons.nearness import nearness, too_near
from vrts.dispatch.planning.reasons.proof import Case, obstacles, unproven
from vrts.dispatch.planning.reasons.refusals import (
    LOST_BY_ROUNDING,
    OTHER_LANGUAGE,
    Sorted,
    place_of,
    sort_out,
)
from vrts.dispatch.planning.reasons.rounding import lost, same_instructions
from vrts.dispatch.planning.scened import Scened
from vrts.dispatch.planning.wish import Wish
from vrts.dispatch.profile import Profile
from vrts.engine.controller import execute
from vrts.ir.module import Module
from vrts.lang.compiler import Compilation
from vrts.pipeline.execution import compiled_for, entry_in
from vrts.pipeline.setting import Setting, scenario_of
from vrts.prove.environment.environment import Environment
from vrts.prove.explore.answering import with_answers

LONGEST_TITLE = 200  # characters of the title of a scenario


class Plan(NamedTuple):
    """What came of it."""

    bundle: Bundle | None  # None: refused
    refused: tuple[Diagnostic, ...]
    waived: tuple[Diagnostic, ...] = ()
    idle: tuple[str, ...] = ()  # codes of waivers that nothing needed


def plan(wish: Wish) -> Plan:
    """Return the bundle of a program, or why there is none.

    Args:
        wish: The program, and in what it is to be verified for which controller.
    """
    request = wish.request
    source, compilation, said = compiled_for(request)
    if source is None or compilation is None or compilation.module is None:
        return Plan(None, tuple(d for d in said if d.is_error))
    given, profile = compilation.module, wish.profile
    entry, chosen = entry_in(given, request)
    if entry is None or chosen:  # nothing is guessed for a real robot
        return Plan(None, tuple(replace(d, severity=Severity.ERROR) for d in chosen))
    if compilation.dialect.angles is not profile.language.angles:
        return Plan(None, (_other_language(compilation, profile),))
    texts = printed(compilation, profile)
    found = [*fits.fits(texts, given, profile), *fits.truncated(compilation.diagnostics)]
    read = read_back(texts, entry, profile, request.reading.precedence)
    if read.module is None or not same_instructions(given, read.module):
        return _sorted(wish, [*found, *_unreadable(read, profile)]).plan
    found += lost(given, read.module)
    held = Module(given.programs, read.module.data)  # the same programs, with places in their file
    asked = wish.clearance_mm * MM
    scened: list[Scened] = []
    for setting in wish.settings:
        world = _world(setting, held, wish.environment, entry)
        scened.append(_scened(setting, world, given, held, entry, asked, said))
        request.step_done("verify")
    known = dependence.dependence(given)
    seen = coverage.covered([one.held.run for one in scened])
    found += _of_scenarios(scened, asked)
    result = _sorted(wish, found)
    if result.plan.refused:  # futures are looked at when the scenarios are as they should be
        return result.plan
    proven = futures.proofs_of(held, wish.settings, wish.environment, entry, wish.workers)
    request.step_done("prove")
    for proof in proven:
        found += futures.refused(given, proof)
    found += dependence.not_covered(
        known, seen, lambda source: futures.is_tried(wish.environment, held, proven, source)
    )
    result = _sorted(wish, found)
    if result.plan.refused:  # other worlds are looked at when this one is as it should be
        return result.plan
    scened = [_with_margins(one, held, wish, entry) for one in scened]
    result = _sorted(wish, [*found, *(d for one in scened for d in margins.refused(one.margins))])
    request.step_done("margins")
    if result.plan.refused:
        return result.plan
    raised = _dry_run(scened[0], held, entry, profile, asked)
    request.step_done("dry run")
    typed = Held(read.module, texts, profile.language.name, request.reading.precedence)
    proofs = [shown(typed, one, s, entry) for one, s in zip(scened, wish.settings, strict=True)]
    request.step_done("certificate")
    made = Made(
        request.program.name,
        request.program.data,
        entry,
        texts,
        given,
        held,
        profile,
        wish.clearance_mm,
        seen,
        known,
        result.sorted,
        raised,
        proofs,
        tuple(futures.told(wish.environment, proof) for proof in proven),
        kept(wish),
    )
    bundle = bundle_of(made, scened, wish.settings)
    return result.plan._replace(bundle=bundle)


class _Result(NamedTuple):
    plan: Plan
    sorted: Sorted


def _sorted(wish: Wish, found: Sequence[Diagnostic]) -> _Result:
    result = sort_out(_distinct(found), wish.promises)
    return _Result(Plan(None, result.refused, result.waived, result.idle), result)


def _world(setting: Setting, module: Module, environment: Environment, entry: str) -> World:
    """Return where a program runs; at PROMPT is typed what the environment allows, too."""
    task, scenario = setting.task, scenario_of(setting)
    if task is not None:
        task = replace(task, proof=None)  # every future is looked at here for all scenarios
    return World(
        setting.scene, task, with_answers(module, setting.scene, scenario, environment, entry)
    )


def _scened(
    setting: Setting,
    world: World,
    given: Module,
    held: Module,
    entry: str,
    asked: float,
    said: Sequence[Diagnostic],
) -> Scened:
    title = "as it is" if setting.scenario is None else setting.scenario.title[:LONGEST_TITLE]
    first = _case(title, given, world, entry)._replace(said=tuple(said))
    case = _case(title, held, world, entry)
    near = nearness(world.scene, case.run, asked)
    return Scened(world, first, case, near, (), margins.NOT_PROVEN, ())


def _with_margins(one: Scened, held: Module, wish: Wish, entry: str) -> Scened:
    if obstacles(one.held):
        return one
    subject = Subject(held, entry, one.world, one.held.run, one.near.clearance_m)
    with Memory().in_use():  # most motions are the same in most worlds
        found = margins.margins(subject, wish.workers)
        failed = next((m for m in found if m.answer == "violated"), None)
        if failed is not None:
            return one._replace(margins=found, first_to_fail=f"{failed.name}: {failed.sentence}")
        words = margins.NOT_ASKED
        if wish.fails_first:
            words = margins.first_to_fail(subject, wish.workers)
        stopped = stops(subject, wish.environment, wish.workers)
    return one._replace(margins=found, first_to_fail=words, stops=stopped)


def _case(title: str, module: Module, world: World, entry: str) -> Case:
    run = execute(module, world.scene, world.scenario, entry)
    return Case(title, run, judge(world.scene, run, world.task), world.task)


def _of_scenarios(scened: Sequence[Scened], asked: float) -> Iterator[Diagnostic]:
    named = len(scened) > 1
    for one in scened:
        wrong = list(unproven(one.given, named=named))
        yield from wrong
        if not wrong:
            for sentence in obstacles(one.held):
                yield error(
                    LOST_BY_ROUNDING,
                    f"with the values as the controller prints them: {sentence}",
                    help=("write locations with no more decimals than the controller has",),
                )
        yield from too_near(one.near, asked, OBJECTS + BASE)


def _dry_run(one: Scened, module: Module, entry: str, profile: Profile, asked: float) -> DryRun:
    if obstacles(one.held):
        return NO_DRY_RUN._replace(problem="the program itself is not proven")
    return dry_run(module, entry, one.world, one.held.run, profile.language, asked)


def _unreadable(read: Compilation, profile: Profile) -> Iterator[Diagnostic]:
    """Yield what the controller's language makes of a program that it cannot read."""
    errors = [d for d in read.diagnostics if d.is_error]
    for found in errors:
        yield error(
            OTHER_LANGUAGE,
            f"the controller cannot read this: {found.headline}",
            found.primary,
            notes=(f"profile `{profile.name}`, {profile.language.title}",),
            help=found.help or ("write it as the language of the controller has it",),
        )
    if not errors:
        yield error(
            OTHER_LANGUAGE,
            "the controller reads this program as another one than its file",
            notes=(f"profile `{profile.name}`, {profile.language.title}",),
            help=("give the `--dialect` and `--prec` that the controller has",),
        )


def _other_language(compilation: Compilation, profile: Profile) -> Diagnostic:
    return error(
        OTHER_LANGUAGE,
        f"the controller speaks {profile.language.title}, the program is written in "
        f"{compilation.dialect.title}",
        notes=(f"profile `{profile.name}`",),
        help=(f"export it to {profile.language.title} first, or choose another `--profile`",),
    )


def _distinct(found: Sequence[Diagnostic]) -> list[Diagnostic]:
    """Return refusals once, although several scenarios may give the same."""
    kept = {(*place_of(d), d.headline): d for d in reversed(found)}
    return list(reversed(kept.values()))
