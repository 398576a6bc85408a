"""What is asked for: one program, how it is read, where it runs, and what is to be found out."""

from collections.abc import Callable
from typing import NamedTuple

from vrts.base.workers import ALONE, Workers
from vrts.geometry.proposing.proposer import Proposer
from vrts.pipeline.compiling.reading import STRICT, ProgramFile, Reading
from vrts.pipeline.setting import Setting
from vrts.scene.model import Limits


class Checks(NamedTuple):
    """What is to be found out about a run."""

    judged: bool = True  # whether to check and mark at all
    collisions: bool = True
    proposer: Proposer | None = None  # of directions and points; None: the best there is here
    second: Proposer | None = None  # gives a second opinion, which decides nothing; None: nobody
    curve: bool = False  # whether to sample the clearance over time, for charts
    causes: bool = False  # whether to look for what led to each loss
    workers: Workers = ALONE  # who replays futures that seem to go wrong


ALL_CHECKS = Checks()
NO_CHECKS = Checks(judged=False)


class Request(NamedTuple):
    """One program and everything that its assessment depends on; and who is told of its stages."""

    program: ProgramFile
    setting: Setting
    reading: Reading = STRICT
    entry: str | None = None  # program to execute; None: the task's, else the main one
    checks: Checks = ALL_CHECKS
    identifier: str = "program"  # safe for file names
    title: str | None = None  # as reports show it; None: the name of the program
    limits: Limits | None = None  # of its run; None: those of scenario and task
    step_done: Callable[[str], None] = lambda _: None  # told the name of every stage that is done
