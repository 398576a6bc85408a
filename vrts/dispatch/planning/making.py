"""The bundle of a program that was not refused: its manifest, its texts, its sheet."""

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from enum import Enum
from types import MappingProxyType
from typing import NamedTuple, cast

import msgspec

from vrts import __version__
from vrts.base.units import mm
from vrts.check.mark.mark import grade
from vrts.check.verdicts.duration import duration
from vrts.controllers.values import digest
from vrts.dispatch.bundle import (
    NO_MEMBERS,
    Bundle,
    content_digest,
    digest_of,
    proof_name,
    with_sheet,
)
from vrts.dispatch.manifest import (
    SCHEMA,
    Answered,
    Futures,
    Manifest,
    Margin,
    Shown,
    Thing,
    Verified,
)
from vrts.dispatch.planning.asked import Kept
from vrts.dispatch.planning.beside.dry_run import DryRun
from vrts.dispatch.planning.printed import Printed
from vrts.dispatch.planning.proving import Certified
from vrts.dispatch.planning.reasons.coverage import Covered, executed_steps
from vrts.dispatch.planning.reasons.dependence import Dependence, reads
from vrts.dispatch.planning.reasons.proof import Case
from vrts.dispatch.planning.reasons.refusals import Sorted
from vrts.dispatch.planning.reasons.rounding import largest
from vrts.dispatch.planning.scened import Scened
from vrts.dispatch.planning.sheet.sheet import Sheet, sheet
from vrts.dispatch.profile import Profile
from vrts.ir.module import Module
from vrts.pipeline.setting import Setting

_PATHS = ("/", "\\")


class Made(NamedTuple):
    """All that a bundle is made of, beside its scenarios."""

    name: str  # of the program's file, as shown
    data: bytes
    entry: str
    texts: Printed
    given: Module  # as the file has it
    held: Module  # as the controller will hold it
    profile: Profile
    clearance_mm: float
    seen: Covered
    known: Dependence
    sorted: Sorted
    raised: DryRun
    proofs: Sequence[Certified]  # one for each scenario
    futures: tuple[Futures, ...]  # as many
    kept: Kept  # what was asked for


def bundle_of(made: Made, scened: Sequence[Scened], settings: Sequence[Setting]) -> Bundle:
    """Return the bundle of a program verified in scenarios."""
    manifest = _manifest(made, scened, settings)
    texts = made.texts
    programs: Mapping[str, str] = MappingProxyType(dict(texts.programs))
    proofs = {
        proof_name(number): proof.certificate
        for number, proof in enumerate(made.proofs, 1)
        if proof.certificate is not None
    }
    bundle = Bundle(
        manifest,
        programs,
        texts.locations,
        texts.reals,
        texts.strings,
        "",
        proofs,
        made.kept.files,
    )
    facts = Sheet(
        bundle=bundle,
        content=content_digest(bundle),
        profile=made.profile,
        scene=settings[0].scene,
        run=scened[0].held.run,
        raised=made.raised,
        passages=tuple(passage for one in scened for passage in one.near.shown),
        rounding=largest(made.given, made.held),
    )
    return with_sheet(bundle, sheet(facts))


def _manifest(made: Made, scened: Sequence[Scened], settings: Sequence[Setting]) -> Manifest:
    scene, task = settings[0].scene, settings[0].task
    several = len(scened) > 1
    return Manifest(
        schema=SCHEMA,
        vrts=__version__,
        title=_base_name(made.name),
        entry=made.entry,
        program=Thing(_base_name(made.name), digest_of(made.data)),
        scene=Thing(scene.name, scene.digest),
        robot=Thing(scene.robot.arm.title, record_digest(scene.robot)),
        task=None if task is None else Thing(task.title, task.digest),
        profile=made.profile.name,
        profile_sha256=made.profile.digest,
        dialect=made.profile.dialect,
        scenarios=tuple(
            _verified(one, setting, _shown(number, proof))
            for number, (one, setting, proof) in enumerate(
                zip(scened, settings, made.proofs, strict=True), 1
            )
        ),
        executed=executed_steps(made.given, made.seen),
        reads=reads(made.known),
        clearance_asked_mm=made.clearance_mm,
        margins=tuple(
            m if not several else _named(m, one.held.title)
            for one in scened
            for m in (*one.margins, *one.stops)
        ),
        first_to_fail="; ".join(dict.fromkeys(one.first_to_fail for one in scened))[:2_000],
        waivers=made.sorted.waivers,
        files=NO_MEMBERS,
        controller=Thing(scene.controller.name, digest(scene.controller)),
        futures=made.futures,
        asked=made.kept.asked,
    )


def _shown(number: int, proof: Certified) -> Shown:
    file = None if proof.certificate is None else proof_name(number)
    return Shown(file, proof.scenario_sha256, proof.summary[:2_000])


def _verified(one: Scened, setting: Setting, proof: Shown) -> Verified:
    case, took = one.held, duration(one.held.run)
    clearance = one.near.clearance_m
    return Verified(
        scenario=case.title,
        sha256=None if setting.scenario is None else setting.scenario.digest,
        ending=case.run.ending.value,
        duration_s=None if took is None else float(took),
        statements=case.run.statements,
        motions=len(case.run.motions),
        mark=_mark(case),
        clearance_mm=None if clearance is None else round(mm(clearance), 2),
        verdicts=tuple(
            Answered(v.check, v.answer.value, v.summary[:2_000]) for v in case.judgement.verdicts
        ),
        proof=proof,
    )


def _mark(case: Case) -> float | None:
    if case.task is None:
        return None
    return float(grade(case.task, case.run, case.judgement).mark)


def _named(margin: Margin, scenario: str) -> Margin:
    return msgspec.structs.replace(margin, name=f"{margin.name}, {scenario}")


def record_digest(value: object) -> str:
    """Return the sha256 of a plain record: the same for the same values, in every process."""
    return hashlib.sha256(_written(value).encode()).hexdigest()


def _written(value: object) -> str:
    if isinstance(value, Enum):
        return value.name
    if isinstance(value, frozenset):
        members = cast("frozenset[object]", value)
        return "{" + ",".join(sorted(_written(member) for member in members)) + "}"
    if isinstance(value, tuple):
        parts = cast("tuple[object, ...]", value)
        return f"{parts.__class__.__name__}({','.join(_written(part) for part in parts)})"
    if is_dataclass(value) and not isinstance(value, type):
        held = ((f.name, getattr(value, f.name)) for f in fields(value))
        # what was found of an arm came later than digests did: where nothing was, they stay
        named = (f"{name}={_written(v)}" for name, v in held if name != "built" or v is not None)
        return f"{value.__class__.__name__}({','.join(named)})"
    return repr(value)


def _base_name(name: str) -> str:
    """Return the last part of a path: a bundle names no folder of whoever made it."""
    for separator in _PATHS:
        name = name.rpartition(separator)[2]
    return name[:200]
