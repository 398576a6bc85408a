"""What is to be planned: a program as it is verified, and the controller that it is for."""

from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.base.workers import ALONE, Workers
from vrts.dispatch.planning.reasons.futures import USUAL
from vrts.dispatch.planning.reasons.refusals import Promise
from vrts.dispatch.profile import Profile
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.prove.environment.environment import Environment

CLEARANCE_MM = 10.0  # asked for, unless somebody asks for another


class Wish(NamedTuple):
    """What is to be planned."""

    request: Request  # the program, in the first scenario
    profile: Profile
    clearance_mm: float = CLEARANCE_MM
    promises: tuple[Promise, ...] = ()
    further: tuple[Setting, ...] = ()  # one for each other scenario
    environment: Environment = USUAL  # what may come from outside
    fails_first: bool = (
        False  # whether to look which margin fails first: takes longer than the rest
    )
    workers: Workers = ALONE  # that look at worlds
    environment_source: SourceFile | None = None  # the file that it was given in

    @property
    def settings(self) -> tuple[Setting, ...]:
        """One setting for each scenario."""
        return (self.request.setting, *self.further)
