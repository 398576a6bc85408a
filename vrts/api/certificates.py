"""Certificates: what proves that the contacts found are those there are."""

from pathlib import Path

from vrts.api.assessments import ITS_OWN, Assessment
from vrts.api.errors import VrtsError, public, refuse
from vrts.api.given import File, Program, path_of
from vrts.api.runs import written
from vrts.api.scenes import Scene, Task
from vrts.api.verifying import verify
from vrts.report.assessment import Assessment as Inner
from vrts.report.quantities import millimetres
from vrts.report.screen.proof_text import About, proof_text
from vrts.run_files.proving import Proof as InnerProof
from vrts.run_files.proving import certificate_of, proof_of, scenario_digest
from vrts.run_files.simulated import Simulated

NAME = "run.cert"
NOTHING_RAN = "nothing ran, so there is nothing to prove"
NOT_CHECKED = "collisions were not checked, so there is nothing to prove"


class Certificate:
    """A certificate that holds: a small checker that believes nothing else has checked it."""

    def __init__(self, data: bytes, proof: InnerProof) -> None:
        """Take the bytes of the file, and what they prove."""
        self.data = data
        self._proof = proof

    @property
    def clearance_mm(self) -> float | None:
        """What must not touch is at least so far apart at every instant, in mm."""
        metres = self._proof.claims.clearance_m
        return None if metres is None else millimetres(metres)

    @property
    def contacts(self) -> int:
        """How many contacts there are; no other."""
        return len(self._proof.claims.meetings)

    @public
    def save(self, path: File) -> Path:
        """Write the certificate to a file, which `vrts check-proof` checks; return its path.

        Raises:
            VrtsError: It cannot be written.
        """
        place = path_of(path)
        written(place, self.data)
        return place

    def __repr__(self) -> str:
        """Return the certificate in a line."""
        return f"<vrts.Certificate of {self.contacts} contacts, {len(self.data):,} bytes>"

    def __str__(self) -> str:
        """Return what `vrts check-proof` prints."""
        return said_of(self._proof)


def said_of(proof: InnerProof) -> str:
    """Return what a certificate proves, as `vrts check-proof` prints it."""
    run, origin = proof.made.run, proof.made.origin
    assert run is not None
    assert origin is not None
    about = About(proof.name, proof.size, run, origin, scenario_digest(run, origin))
    return proof_text(about, proof.claims, proof.proven)


def certified(found: Inner, simulated: Simulated) -> bytes:
    """Return the certificate of what was found of a program.

    Raises:
        VrtsError: Nothing ran, or collisions were not checked.
        Refused: It cannot be shown.
    """
    report = None if found.judgement is None else found.judgement.collisions
    if report is None:
        raise VrtsError(NOTHING_RAN if found.run is None else NOT_CHECKED)
    return certificate_of(simulated, report)


@public
def certificate(
    program: Program | Assessment,
    *,
    scene: File | Scene | None = None,
    task: File | Task | None = None,
    scenario: File | None = None,
) -> Certificate:
    r"""Prove that the contacts found in a run are those there are, and check the proof.

    Args:
        program: What `vrts.verify` gave, or a program as for it.
        scene: As for `vrts.verify`.
        task: As for `vrts.verify`.
        scenario: As for `vrts.verify`.

    Raises:
        VrtsError: Nothing ran, collisions were not checked, or it cannot be proven. An assessment
            has its own scene, task and scenario: give no others.

    >>> import vrts
    >>> turn = ".PROGRAM turn()\nDRIVE 1, 30, 100\n.END\n"
    >>> vrts.certificate(turn, scene="cans-on-bases").contacts
    0
    """
    if isinstance(program, Assessment):
        refuse(ITS_OWN, scene=scene, task=task, scenario=scenario)
        found = program
    else:
        found = verify(program, scene=scene, task=task, scenario=scenario)
    data = certified(found.inner, found.simulated)
    return Certificate(data, proof_of(data, NAME))
