"""The file of a run."""

from vrts.base.diagnostic import Diagnostic
from vrts.engine.storage.save import run_bytes
from vrts.pipeline.refused import Refused
from vrts.run_files.simulated import Simulated


def saved_bytes(simulated: Simulated) -> bytes:
    """Return the file of a run.

    Raises:
        Refused: It cannot be saved.
    """
    assert simulated.run is not None
    assert simulated.origin is not None
    found = run_bytes(simulated.run, simulated.origin)
    if isinstance(found, Diagnostic):
        raise Refused((found,))
    return found
