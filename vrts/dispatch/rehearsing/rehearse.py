"""A folder for LinuxCNC read, carried out and compared with its run."""

from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.dispatch.linuxcnc.export import ACCELERATION, HAL, INI, LIBRARY, PROGRAM, RUN, SETUP
from vrts.dispatch.rehearsing.installed import Installed
from vrts.dispatch.rehearsing.measured import Stretch, extra, measured
from vrts.dispatch.rehearsing.running import rehearsed
from vrts.dispatch.rehearsing.samples import Samples, read_samples
from vrts.engine.controller import execute
from vrts.engine.memory.events import ProgramStarted
from vrts.engine.run import Run
from vrts.pipeline.refused import Refused
from vrts.run_files.loading import load_run
from vrts.scene.model import Scenario

NOT_A_FOLDER = Rule("V874", "linuxcnc-folder")
REFUSED = Rule("V875", "linuxcnc-refuses")
MOVES_OTHERWISE = Rule("V876", "linuxcnc-moves-otherwise")

NEEDED = (PROGRAM, RUN, INI, HAL, ACCELERATION, SETUP)
MOST_TOLD = 5  # stretches, of those that do not hold


class Rehearsal(NamedTuple):
    """What LinuxCNC did, beside the run."""

    run: Run
    samples: Samples
    stretches: tuple[Stretch, ...]
    words: tuple[str, ...]  # that the program printed, and other messages
    diagnostics: tuple[Diagnostic, ...]  # errors: it does not hold
    log: str = ""  # of LinuxCNC's own processes

    @property
    def holds(self) -> bool:
        """Whether LinuxCNC did what the sheet claims."""
        return not any(d.is_error for d in self.diagnostics)


def expected(folder: Path) -> Run:
    """Return the run of an exported folder.

    Raises:
        Refused: It is no such folder, or a file of it is missing or damaged.
    """
    missing = [name for name in NEEDED if not (folder / name).is_file()]
    if missing:
        note = f"a folder for LinuxCNC holds it, and the folder `{LIBRARY}`"
        raise Refused((_no_folder(f"`{folder}` has no `{missing[0]}`", note),))
    linked = [path for path in sorted(folder.rglob("*")) if path.is_symlink()]
    if linked:
        note = "it is copied, and a link may lead anywhere"
        raise Refused((_no_folder(f"`{linked[0]}` is a link", note),))
    found = load_run((folder / RUN).read_bytes(), RUN, folder)
    if found.run is None:
        raise Refused(found.diagnostics)
    return found.run


def _no_folder(headline: str, note: str) -> Diagnostic:
    return error(
        NOT_A_FOLDER,
        headline,
        notes=(note,),
        help=("write it: `vrts dispatch export PROGRAM --to linuxcnc -o FOLDER`",),
    )


def with_scenario(run: Run, scenario: Scenario) -> Run:
    """Return the run of the same programs in the same scene, with other inputs."""
    started = next(e for e in run.events if isinstance(e, ProgramStarted) and not e.process)
    return execute(run.module, run.scene, scenario, started.program)


def rehearse(folder: Path, run: Run, what: Installed, speed: float) -> Rehearsal:
    """Carry out a folder and compare it with its run.

    Args:
        folder: What was exported.
        run: The run with the inputs that are played.
        what: LinuxCNC.
        speed: How many times faster than the clock.
    """
    outcome = rehearsed(folder, run, what, speed)
    samples = read_samples(outcome.samples)
    if outcome.errors:
        told = tuple(_refused(words) for words in outcome.errors)
        return Rehearsal(run, samples, (), outcome.words, told, outcome.log)
    stretches = measured(run, samples)
    told = tuple(_otherwise(s) for s in stretches if not s.holds)[:MOST_TOLD]
    more = extra(run, samples)
    if more:
        told = (*told, _more(more))
    return Rehearsal(run, samples, stretches, outcome.words, told, outcome.log)


def _refused(words: str) -> Diagnostic:
    return error(
        REFUSED,
        f"LinuxCNC does not carry the program out: {words}",
        help=("look at what was edited in the folder, or export it again",),
    )


def _otherwise(s: Stretch) -> Diagnostic:
    if s.missing:
        headline = f"LinuxCNC never makes motion {s.first} ({s.line})"
        note = "the program took another way there, or ended before"
    else:
        several = f"motions {s.first} to {s.last}" if s.last > s.first else f"motion {s.first}"
        headline = f"LinuxCNC moves otherwise in {several} ({s.line})"
        note = (
            f"path {s.path_mm:.3f} mm, equal time {s.equal_mm:.3f} mm, end {s.end_mm:.3f} mm,"
            f" {1e3 * s.longer_s:+.1f} ms"
        )
    return error(MOVES_OTHERWISE, headline, notes=(note,))


def _more(count: int) -> Diagnostic:
    return error(
        MOVES_OTHERWISE,
        f"LinuxCNC makes {count} motion{'s' if count > 1 else ''} more than the run",
        notes=("the program took another way there",),
    )
