"""All that is known about one program: what every report is written from."""

from dataclasses import dataclass

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Grade
from vrts.check.rules.hints import Hints, without_remedy
from vrts.check.task.task import Task
from vrts.engine.motion.remarks import without_forecasts
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.prove.proof import Proof
from vrts.scene.model import Scene
from vrts.why.chain import Chain


@dataclass(frozen=True, slots=True)
class Assessment:
    """One program and what the stages said. Later fields are None where a stage was not reached."""

    identifier: str  # file stem or submission id, safe for file names
    title: str  # as shown: "solution.v2"
    source: SourceFile | None  # None when the file could not be read as text
    diagnostics: tuple[Diagnostic, ...]  # of reading and compiling
    module: Module | None = None
    scene: Scene | None = None
    task: Task | None = None
    run: Run | None = None
    judgement: Judgement | None = None
    grade: Grade | None = None
    clearance: tuple[tuple[float, float], ...] = ()  # (time [s], smallest distance [m]), sampled
    proof: Proof | None = None  # of every future; None: no task asks for it
    chains: tuple[Chain, ...] = ()  # what led to each loss, beside `grade.losses`; if asked for

    @property
    def findings(self) -> tuple[Diagnostic, ...]:
        """Every diagnostic: of compiling, of the run in time order, of the checks."""
        found = list(self.diagnostics)
        if self.run is not None:
            said = without_forecasts(self.run.findings) if self.judgement else self.run.findings
            silent = self.task is not None and self.task.hints is Hints.NOTHING
            found += map(without_remedy, said) if silent else said
        if self.judgement is not None:
            found += [d for verdict in self.judgement.verdicts for d in verdict.findings]
        return tuple(found)
