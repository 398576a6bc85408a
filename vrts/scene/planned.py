"""A scenario as a file plans it."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.scene.model import Scenario


class ScenarioFile(NamedTuple):
    """What a scenario file says."""

    title: str
    scenario: Scenario
    digest: str  # sha256 of the file
    warnings: tuple[Diagnostic, ...] = ()
