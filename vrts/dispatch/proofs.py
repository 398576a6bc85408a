"""The certificates in a bundle, checked: each holds, and is about what is to be sent.

A file that is sound may still have been made by anybody. What is checked here does not depend on
who made it: the texts of the bundle are executed again, and the contacts are shown again.
"""

from collections.abc import Iterator

from vrts.base.diagnostic import error
from vrts.base.units import mm
from vrts.dispatch.bundle import Bundle, files_of
from vrts.dispatch.manifest import WITHOUT_PROOFS, Shown, Verified
from vrts.ir.commands import Execute, TimedCommand
from vrts.pipeline.refused import Refused
from vrts.run_files.proving import OTHER, Proof, base_name, proof_of, scenario_digest

HUNDREDTH = 0.011  # [mm] by which two numbers that are rounded may differ
PLAN_AGAIN = "plan the bundle again with `vrts dispatch plan`: nothing was sent"


def check_proofs(bundle: Bundle) -> tuple[str, ...]:
    """Check every certificate of a bundle; return what there is to say of those it lacks.

    Raises:
        Refused: A certificate does not hold, or is about something else than the bundle.
    """
    if bundle.manifest.schema == WITHOUT_PROOFS:
        return ("this bundle is of an older format, which holds no certificate of its runs",)
    return tuple(_notes(bundle))


def _notes(bundle: Bundle) -> Iterator[str]:
    for one in bundle.manifest.scenarios:
        said = one.proof
        assert said is not None  # by the format
        if said.file is None:
            yield f"scenario {one.scenario}: no certificate of its run ({said.summary})"
            continue
        proof = proof_of(bundle.proofs[said.file], said.file, PLAN_AGAIN)
        what = _differs(bundle, one, said, proof)
        if what is not None:
            headline = f"the certificate `{said.file}` holds, but {what}"
            raise Refused((error(OTHER, headline, help=("plan again: nothing was sent",)),))


def _differs(bundle: Bundle, one: Verified, said: Shown, proof: Proof) -> str | None:
    """Return in what a certificate is not about the run that a bundle tells of, if in anything."""
    manifest, origin, run = bundle.manifest, proof.made.origin, proof.made.run
    assert origin is not None
    assert run is not None
    sections = (bundle.locations, bundle.reals, bundle.strings)
    files = files_of(bundle.programs, manifest.entry, *sections)
    texts = [(source.name, source.text) for source in origin.programs.sources]
    if texts != [(base_name(file.name), file.text) for file in files]:
        return "it is about other programs or data than the bundle"
    if origin.programs.dialect != manifest.dialect:
        return "its program is read in another language"
    if origin.scene.digest != manifest.scene.sha256:
        return "it is about another scene"
    model = manifest.controller
    if model is None or origin.scene.controller_digest != model.sha256:
        return "its run goes by another controller model"
    if scenario_digest(run, origin) != said.scenario_sha256:
        return "it is about another scenario"
    commanded = run.history.issued == (TimedCommand(0.0, Execute(manifest.entry)),)
    same = (one.ending, one.statements, one.motions) == (
        run.ending.value,
        run.statements,
        len(run.motions),
    )
    if not commanded or not same:
        return "its run is another than the bundle tells of"
    free = any(v.check == "collision" and v.answer == "holds" for v in one.verdicts)
    if free and proof.claims.meetings:
        return "it shows a contact, and the bundle says that nothing touches"
    return None if _as_near(one.clearance_mm, proof) else "it proves another smallest distance"


def _as_near(clearance_mm: float | None, proof: Proof) -> bool:
    """Return whether a bundle tells of the smallest distance that a certificate proves."""
    least_m, shown_m = proof.claims.clearance_m, proof.proven.nearest_m
    if clearance_mm is None or least_m is None or shown_m is None:
        return clearance_mm is least_m is None
    return round(mm(least_m), 2) <= clearance_mm <= round(mm(shown_m), 2) + HUNDREDTH
