"""The certificate of each scenario: of the run that the texts of the bundle make, read again."""

from typing import NamedTuple

from vrts.dispatch.bundle import files_of
from vrts.dispatch.planning.printed import Printed
from vrts.dispatch.planning.scened import Scened
from vrts.engine.controller import execute
from vrts.engine.storage.origin import Origin, Programs
from vrts.ir.module import Module
from vrts.pipeline.refused import Refused
from vrts.pipeline.setting import Setting
from vrts.run_files.proving import certificate_of, proof_of, scenario_digest
from vrts.run_files.simulated import Simulated, scene_text

MOST_BYTES = 1_000_000  # of a certificate in a bundle; files of its scene may make it larger


class Held(NamedTuple):
    """What a controller makes of the texts of a bundle."""

    module: Module
    texts: Printed
    dialect: str
    precedence: str | None  # None: as the dialect has it


class Certified(NamedTuple):
    """What shows that the contacts of a run are those that were found."""

    certificate: bytes | None  # None: there is none
    scenario_sha256: str
    summary: str


def shown(held: Held, one: Scened, setting: Setting, entry: str) -> Certified:
    """Return the certificate of a scenario, or why there is none.

    Args:
        held: The programs, as the controller will hold them.
        one: The scenario, with what was found in a run of the same instructions.
        setting: Where its scene comes from.
        entry: The program that is executed.
    """
    texts, world, report = held.texts, one.world, one.near.report  # its distance is told of
    run = execute(held.module, world.scene, world.scenario, entry)
    files = files_of(texts.programs, entry, texts.locations, texts.reals, texts.strings)
    origin = Origin(Programs(files, held.dialect, held.precedence), scene_text(setting))
    hashed = scenario_digest(run, origin)
    if one.held.judgement.collisions is None:
        return Certified(None, hashed, "none: collisions were not checked")
    try:
        certificate = certificate_of(Simulated(run, origin, ()), report)
        proof = proof_of(certificate, "certificate")
    except Refused as refused:
        return Certified(None, hashed, f"none: {refused.diagnostics[0].headline}")
    if len(certificate) > MOST_BYTES:
        return Certified(None, hashed, f"none: it has {len(certificate):,} bytes")
    return Certified(certificate, hashed, f"holds, {proof.proven.leaves:,} intervals")
