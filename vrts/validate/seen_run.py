"""The run that a real robot is compared with, as recordings are written from it."""

from pathlib import Path

from vrts.engine.run import Run
from vrts.report.assessment import Assessment


def assessment_of(run: Run, name: str, kind: str) -> Assessment:
    """Return what recordings need to know of a run that nobody checked.

    Args:
        run: What was simulated.
        name: Of the program, as shown.
        kind: Of recording, for its identifier: "camera".
    """
    identifier = f"{kind}-{Path(name).stem}"
    return Assessment(identifier, name, None, (), module=run.module, scene=run.scene, run=run)
