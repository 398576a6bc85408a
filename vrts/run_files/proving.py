"""Certificates of runs: written of what was found, and checked by executing everything again."""

import re
from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

from vrts import __version__
from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.source import SourceFile
from vrts.check.proof.certificate import (
    MOST_FILES,
    OtherFormat,
    certificate_bytes,
    digest,
    read_certificate,
)
from vrts.check.proof.checker import check
from vrts.check.proof.given import Claims, Proven, Wrong
from vrts.check.proof.record import certified
from vrts.check.verdict import CollisionReport
from vrts.controllers.model import ControllerModel
from vrts.controllers.models import MODELS
from vrts.controllers.values import digest as digest_of_model
from vrts.engine.controller import advance, start
from vrts.engine.run import Run
from vrts.engine.storage.damage import Damaged
from vrts.engine.storage.load import SavedRun, checked_commands, time_of
from vrts.engine.storage.origin import Origin, module_digest, read_origin, write_origin
from vrts.engine.storage.plain import Json, Plain, Unwritable, truth
from vrts.engine.storage.sound_scenario import check_scenario
from vrts.ir.commands import DeletePrograms, Do, Load, TimedCommand
from vrts.pipeline.refused import Refused
from vrts.report.plain import one_line
from vrts.run_files.loading import made_again
from vrts.run_files.simulated import Simulated
from vrts.scene.model import Limits, Locks, Scenario, Scene

DAMAGED = Rule("V546", "damaged-certificate")
NOT_PROVEN = Rule("V547", "certificate-does-not-prove")
NOT_CERTIFIED = Rule("V548", "not-certified")
OTHER = Rule("V549", "other-certificate")
OTHER_FORMAT = Rule("V550", "certificate-format")

WRITE_AGAIN = "write it again with `vrts verify PROGRAM --certificate FILE`"


class Proof(NamedTuple):
    """A certificate that holds."""

    name: str  # of its file, as shown
    made: Simulated  # the run that it is about, executed again
    made_by: str  # version of vrts that wrote it
    claims: Claims
    proven: Proven
    size: int  # of the file [bytes]


def certificate_of(simulated: Simulated, report: CollisionReport) -> bytes:
    """Return the certificate of what was found in a run.

    Raises:
        Refused: It cannot be shown, or the run cannot be described.
    """
    run, origin = simulated.run, simulated.origin
    assert run is not None
    assert origin is not None
    if sum(len(data) for data in run.scene.files.values()) > MOST_FILES:
        raise Refused((_uncertified("the files that its scene names are too large"),))
    changed = [c for c in run.history.issued if isinstance(c.command, Load | Do | DeletePrograms)]
    if changed:
        raise Refused((_uncertified("the programs in memory were changed on the way"),))
    plain = Plain(origin.programs.sources)
    try:
        said: Mapping[str, Json] = {
            "vrts": __version__,
            "origin": write_origin(_placeless(origin, run.scene), run.module),
            "scenario": plain.write(Scenario, run.history.scenario),
            "commands": plain.write(tuple[TimedCommand, ...], run.history.issued),
            "until_s": plain.write(float, run.until_s),
            "closed": run.history.closed,
        }
        found = certified(run.scene, run, report)
    except Unwritable as problem:
        raise Refused((_uncertified(str(problem)),)) from problem
    except Wrong as problem:
        raise Refused((_uncertified(_words(problem)),)) from problem
    return certificate_bytes(said, found.claims, found.evidence, run.scene.files)


def base_name(name: str) -> str:
    """Return the name of a file without its folders."""
    return re.split(r"[/\\]", name)[-1]


def _placeless(origin: Origin, scene: Scene) -> Origin:
    """Return what a run was made of by names that say nothing of folders, nor depend on them."""
    programs, named = origin
    sources = (SourceFile(base_name(s.name), s.text) for s in programs.sources)
    if named.text is not None:
        named = named._replace(name=f"{scene.name}.toml")
    return Origin(programs._replace(sources=tuple(sources)), named)


def proof_of(data: bytes, name: str, again: str = WRITE_AGAIN) -> Proof:
    """Return what a certificate proves.

    Args:
        data: The bytes of the file.
        name: As shown.
        again: How to write it anew, as a help.

    Raises:
        Refused: The file is of another format or not sound, its run cannot be made again, or it
            proves nothing.
    """
    try:
        read = read_certificate(data)
        origin, wanted = read_origin(read.said.get("origin"))
        saved = SavedRun(name, None, read.said, origin, wanted)
        run = _run(saved, read.files, again)
    except OtherFormat as other:
        raise Refused((_other_format(name, other, again),)) from other
    except Damaged as damage:
        headline = f"the certificate `{name}` is damaged: {damage.reason}"
        raise Refused((error(DAMAGED, headline, help=(again,)),)) from damage
    try:
        proven = check(run.scene, run, read.claims, read.evidence)
    except Wrong as wrong:
        raise Refused((_refusal(name, wrong, again),)) from wrong
    made_by = str(read.said.get("vrts"))
    return Proof(
        name, Simulated(run, origin, run.findings), made_by, read.claims, proven, len(data)
    )


def differing(proof: Proof, other: Simulated) -> Diagnostic | None:
    """Return in what another run is not the one that a certificate is about, if in anything."""
    ours, theirs = proof.made.run, other.run
    origin, its = proof.made.origin, other.origin
    assert ours is not None
    assert origin is not None
    if theirs is None or its is None:
        return _other(proof, "the program given does not run")
    programs = [source.text for source in origin.programs.sources]
    if programs != [source.text for source in its.programs.sources]:
        return _other(proof, "it is about another program")
    if module_digest(ours.module) != module_digest(theirs.module):
        return _other(proof, "its program is read in another way")
    if origin.scene.digest != its.scene.digest:
        return _other(proof, "it is about another scene")
    if origin.scene != its.scene._replace(name=origin.scene.name):
        return _other_model(proof, its.scene.controller, "the program given by")
    scenarios = [  # limits and locks change a run, which is compared below, or do not matter
        replace(run.history.scenario, limits=Limits(), locks=Locks()) for run in (ours, theirs)
    ]
    if scenarios[0] != scenarios[1]:
        return _other(proof, "it is about another scenario")
    same = ours.history.issued == theirs.history.issued and ours.horizon_s == theirs.horizon_s
    same = same and ours.timeline.segments == theirs.timeline.segments
    return None if same else _other(proof, "its run was commanded in another way")


def under_another(proof: Proof, model: ControllerModel) -> Diagnostic | None:
    """Return that the run of a certificate goes by another controller model, if it does."""
    assert proof.made.origin is not None
    scene = proof.made.origin.scene
    if (scene.controller, scene.controller_digest) == (model.name, digest_of_model(model)):
        return None
    return _other_model(proof, model.name, "what was asked for is")


def scenario_digest(run: Run, origin: Origin) -> str:
    """Return the hash of a scenario."""
    return digest(Plain(origin.programs.sources).write(Scenario, run.history.scenario))


def _run(saved: SavedRun, files: Mapping[str, bytes], again: str) -> Run:
    """Return the run that a certificate is about, executed again."""
    said, name = saved.manifest, saved.name
    try:
        module, scene = made_again(saved, None, files)
    except Refused as refused:
        notes = tuple(found.headline for found in refused.diagnostics)
        headline = f"the certificate `{name}` cannot be checked: its run cannot be made again"
        raise Refused((error(OTHER, headline, notes=notes, help=(again,)),)) from refused
    for what, same in (
        (
            "its programs compile to something else now",
            module_digest(module) == saved.module_digest,
        ),
        ("its scene is not the one that it names", scene.digest == saved.origin.scene.digest),
    ):
        if not same:
            headline = f"the certificate `{name}` cannot be checked: {what}"
            raise Refused((error(OTHER, headline, help=(again,)),))
    plain = Plain(saved.origin.programs.sources)
    scenario: Scenario = plain.read(Scenario, said.get("scenario"))
    check_scenario(scenario, scene)
    commands: tuple[TimedCommand, ...] = plain.read(tuple[TimedCommand, ...], said.get("commands"))
    begun = start(module, scene, scenario)
    until_s = time_of(said.get("until_s"))
    issued = checked_commands(commands, module)
    return advance(begun, until_s, issued, closed=truth(said.get("closed")))


def _uncertified(reason: str) -> Diagnostic:
    return error(NOT_CERTIFIED, f"no certificate was written: {reason}")


def _other(proof: Proof, what: str) -> Diagnostic:
    return error(OTHER, f"the certificate `{proof.name}` holds, but {what}")


def _other_model(proof: Proof, theirs: str, whose: str) -> Diagnostic:
    assert proof.made.origin is not None
    ours = proof.made.origin.scene.controller
    if ours == theirs:  # as a lab fitted it
        return _other(proof, f"its controller model `{one_line(ours)}` says something else")
    headline = (
        f"the certificate `{proof.name}` holds, but its run goes by the controller model "
        f"`{one_line(ours)}`, {whose} `{one_line(theirs)}`"
    )
    remedy = (f"give `--controller {ours}`",) if ours in MODELS else ()
    return error(OTHER, headline, help=remedy, data={"model": ours, "other": theirs})


def _other_format(name: str, other: OtherFormat, again: str) -> Diagnostic:
    which = "an older" if other.older else "a newer"
    headline = f"the certificate `{name}` was written by {which} vrts, so this one cannot check it"
    notes = (f"{other.reason}; this is vrts {__version__}",)
    return error(OTHER_FORMAT, headline, notes=notes, help=(again,))


def _refusal(name: str, wrong: Wrong, again: str) -> Diagnostic:
    """Return what to tell of a certificate that does not hold: the first thing that does not."""
    data = {} if wrong.time_s is None else {"time_s": round(wrong.time_s, 4)}
    headline = f"the certificate `{name}` does not prove what it claims: {_words(wrong)}"
    return error(NOT_PROVEN, headline, help=(again,), data=data)


def _words(wrong: Wrong) -> str:
    when = "" if wrong.time_s is None else f" at {wrong.time_s:.3f} s"
    who = f" ({' and '.join(wrong.parts)})" if wrong.parts else ""
    return f"{wrong.what}{when}{who}"
