"""The certificate in evidence: what shows that the contacts in a result are those there are."""

from dataclasses import replace

from vrts.base.diagnostic import Diagnostic, Severity
from vrts.check.collision.collision import check_collisions
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.run_files.proving import OTHER_FORMAT, Proof, certificate_of, differing, proof_of
from vrts.run_files.simulated import Simulated, simulate

PROOF = "proof.cert"
PACK_AGAIN = "pack the evidence again with `vrts grade evidence`"


def certificate_for(setting: Setting, title: str, data: bytes) -> bytes | None:
    """Return the certificate of a program that was marked.

    Args:
        setting: That it was marked in.
        title: Of the program.
        data: Its file.

    Returns:
        None where there is none: nothing ran, it cannot be shown, or it takes more than the
        certificate to make the run again.
    """
    made = _made(setting, title, data)
    if made.run is None:
        return None
    near_miss = None if setting.task is None else setting.task.near_miss
    report = check_collisions(made.run.scene, made.run, near_miss=near_miss)
    try:
        written = certificate_of(made, report)
        proof_of(written, PROOF)
    except Refused:
        return None
    return written


def checked_proof(
    certificate: bytes, setting: Setting, title: str, data: bytes
) -> Proof | Diagnostic:
    """Return what the certificate in evidence proves of the program in it.

    Returns:
        Why it cannot be checked, where another vrts has written it in another format.

    Raises:
        Refused: It is damaged, does not hold, or is about something else.
    """
    try:
        proof = proof_of(certificate, PROOF, PACK_AGAIN)
    except Refused as refused:
        if refused.diagnostics[0].rule == OTHER_FORMAT:
            return replace(refused.diagnostics[0], severity=Severity.WARNING)
        raise
    other = differing(proof, _made(setting, title, data))
    if other is not None:
        raise Refused((other,))
    return proof


def _made(setting: Setting, title: str, data: bytes) -> Simulated:
    return simulate(Request(ProgramFile(data, title), setting))
