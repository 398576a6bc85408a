"""A verified program in the language of another controller, and proof that it moves the same."""

from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.units import deg
from vrts.dispatch.posts.checks import checks, with_checks
from vrts.dispatch.posts.expressions_anew import Settled, Start
from vrts.dispatch.posts.other_arm import SAME, OtherArm
from vrts.dispatch.posts.same_motion import TOLERANCE_MM, Difference, difference
from vrts.dispatch.posts.sheet import Given, sheet_text
from vrts.dispatch.posts.written import POSTS, written
from vrts.dispatch.verified import NotVerified, verified
from vrts.engine.controller import execute
from vrts.lang.compiler import Compilation
from vrts.pipeline.compiling.programs import compile_bytes
from vrts.pipeline.compiling.reading import Reading
from vrts.pipeline.execution import compiled_for
from vrts.pipeline.request import Request
from vrts.pipeline.setting import scenario_of
from vrts.scene.model import Scenario

MOVES_OTHERWISE = Rule("V863", "moves-otherwise")
OTHER_LANGUAGE = Rule("V864", "language-not-exported")

LANGUAGES = ("val2", "val2+", "vplus")  # that programs are exported from


class Exported(NamedTuple):
    """A program in another language, or why there is none."""

    text: str | None
    diagnostics: tuple[Diagnostic, ...]
    difference: Difference | None = None  # to the motion of the original
    sheet: str | None = None  # for the operator, in Markdown


def exported(request: Request, target: str, arm: OtherArm | None = SAME) -> Exported:
    """Verify a program, write it in another language, read it again, and compare the motions.

    What is read again counts joints as the arm that was simulated; what is given out, as the other.

    Args:
        request: The program, and where it is verified.
        target: A name of `POSTS`.
        arm: That the text is for; None: how it counts its joints is not known.
    """
    name, setting = request.program.name, request.setting
    compiled = compiled_for(request)
    compilation = compiled.compilation
    if compilation is not None and compilation.dialect.name not in LANGUAGES:
        return Exported(None, (*compilation.diagnostics, _other_language(compilation)))
    found = verified(request, compiled)
    if isinstance(found, NotVerified):
        return Exported(None, found.diagnostics)
    compilation = found.compilation
    scene = setting.scene
    start = Start(found.entry, scene.X_FT)
    settled = Settled(tuple(map(deg, scene.robot.arm.ready)), start, arm)
    text, told = written(compilation, target, settled)
    told = (*compilation.diagnostics, *told)
    if any(d.is_error for d in told):
        return Exported(None, told)
    holds = None if arm is None else arm.holds
    alike = settled._replace(arm=SAME._replace(holds=holds))
    other = _compiled(written(compilation, target, alike).text, name, target)
    if other.module is None:
        return Exported(None, (*told, *other.diagnostics))
    scenario = _holding(scenario_of(setting), holds)
    run = execute(other.module, scene, scenario, found.entry)
    apart = difference(found.run, run)
    if not apart.is_none:
        return Exported(None, (*told, *run.findings, _moves_otherwise(target, apart)), apart)
    dialect = POSTS[target].dialect
    places = checks(found.run)
    asked = holds if holds is not None and f"SIG({-holds})" in text else None
    given = Given(name, dialect, found.run, arm, asked, apart)
    noted = with_checks(text, found.entry, places, dialect)
    return Exported(noted, told, apart, sheet_text(given, places))


def _holding(scenario: Scenario, signal: int | None) -> Scenario:
    """Return a scenario in which the signal of the hand is on: every grip succeeded."""
    if signal is None:
        return scenario
    return replace(scenario, inputs=((0.0, signal, True), *scenario.inputs))


def default_sheet(place: Path) -> Path:
    """Return where the sheet of an exported program goes."""
    return place.with_name(f"{place.stem}-sheet.md")


def default_name(program: Path, target: str) -> Path:
    """Return where an exported program goes unless told otherwise."""
    return program.with_name(f"{program.stem}-{target}{POSTS[target].suffix}")


def _compiled(text: str, name: str, target: str) -> Compilation:
    _, compilation, _ = compile_bytes(text.encode(), f"{target}: {name}", Reading(target))
    assert compilation is not None
    return compilation


def _other_language(compilation: Compilation) -> Diagnostic:
    return error(
        OTHER_LANGUAGE,
        f"programs in {compilation.dialect.title} are not exported",
        help=("export a program in VAL-II or V+",),
    )


def _moves_otherwise(target: str, apart: Difference) -> Diagnostic:
    title = POSTS[target].dialect.title
    if apart.most_mm > TOLERANCE_MM:
        headline = f"in {title} the tool would be {apart.most_mm:.2f} mm elsewhere"
        note = f"from {apart.first_s:.2f} s on"
    else:
        headline = f"in {title} the program would take {apart.duration_s:+.3f} s"
        note = "the path is the same"
    return error(
        MOVES_OTHERWISE,
        headline,
        notes=(note,),
        help=("write what the languages carry out in different ways by plain motions",),
    )
