"""Every future of a program."""

from pathlib import Path
from typing import NamedTuple

from vrts.api.errors import VrtsError, public, refusal
from vrts.api.given import File, Program, given, optional_path, path_of, reading, word
from vrts.api.requests import outside, run_request, verify_request
from vrts.api.runs import written
from vrts.api.scenes import Scene, Task
from vrts.api.settings import setting_read, where_of
from vrts.api.verifying import STRICT
from vrts.assignments.packed import found_setting
from vrts.check.verdict import Answer
from vrts.pipeline.futures import Proved, proved
from vrts.prove.asking import USUAL_STATES, Asking
from vrts.prove.proof import Proof as Inner
from vrts.prove.proof import Wronged
from vrts.report.screen.futures_text import futures_text
from vrts.scene.writing.scenario_text import scenario_text


class Future(NamedTuple):
    """A future that goes wrong, the shortest of those with the same cause."""

    words: str  # what goes wrong, in a sentence
    kind: str  # "contact", "endless loop", …
    time_s: float
    line: int | None  # of the program
    scenario: str  # the text of a scenario file that shows it: `vrts.run(…, scenario=…)`

    def save(self, path: File) -> Path:
        """Write the scenario file that shows it; return its path.

        Raises:
            VrtsError: It cannot be written.
        """
        place = path_of(path)
        written(place, self.scenario.encode())
        return place


class Proof:
    """What was found of all futures of a program. Made by `vrts.prove`."""

    def __init__(self, title: str, proof: Inner) -> None:
        """Take what was found."""
        self._title = title
        self._proof = proof

    @property
    def answer(self) -> str:
        """Return "holds", "violated", or "undetermined": not all futures could be looked at."""
        return self._proof.answer.value

    @property
    def holds(self) -> bool:
        """Whether nothing can go wrong, whatever comes from outside."""
        return self._proof.answer is Answer.HOLDS

    @property
    def futures(self) -> tuple[Future, ...]:
        """Those that go wrong, the shortest first."""
        return tuple(map(_future, self._proof.found))

    @property
    def states(self) -> int:
        """How many states were looked at."""
        return self._proof.covered.states

    @property
    def open(self) -> tuple[str, ...]:
        """What was not looked at, where the answer is undetermined."""
        return self._proof.open

    def __repr__(self) -> str:
        """Return the answer in a line."""
        return f"<vrts.Proof {self._title}: {self.answer}, {self.states} states>"

    def __str__(self) -> str:
        """Return what `vrts prove` prints."""
        return futures_text(self._title, self._proof, color=False)


def proof_in(found: Proved) -> Inner:
    """Return the proof of a program.

    Raises:
        VrtsError: The program does not compile, so there are no futures.
    """
    if found.proof is None:
        raise refusal(found.diagnostics)
    return found.proof


def scenario_of(wronged: Wronged) -> str:
    """Return the text of a scenario file that shows a future."""
    return scenario_text(wronged.headline, wronged.scenario)


def _future(wronged: Wronged) -> Future:
    line = None if wronged.cause is None else wronged.cause.span.line
    kind = wronged.wrong.value
    return Future(wronged.headline, kind, wronged.time_s, line, scenario_of(wronged))


@public
def prove(
    program: Program,
    *,
    environment: File | None = None,
    scene: File | Scene | None = None,
    task: File | Task | None = None,
    scenario: File | None = None,
    entry: str | None = None,
    dialect: str | None = None,
    files: tuple[File, ...] = (),
    states: int = USUAL_STATES,
    collisions: bool = True,
) -> Proof:
    r"""Look at every future of a program: all inputs, at every moment at which they matter.

    Args:
        program: A path, or the text of a program, which has several lines.
        environment: A file that says what may come from outside; None: the task's, else whatever
            the program reads is free.
        scene: Where it runs; without scene and task: as the task beside the file has it, else a
            robot alone.
        task: Where it runs, and what is asked for.
        scenario: How every future begins, and what is the same in all.
        entry: Program of the file to execute; None: the task's, else the main one.
        dialect: `val2`, `val2+`, `val`, `vplus`, `as` or `auto`; None: `val2`; for a robot
            alone as name and content tell.
        files: Compiled together with the program.
        states: Look at no more than so many states.
        collisions: Whether to check them.

    Raises:
        VrtsError: The program does not compile, or a file is not there or has errors.

    >>> import vrts
    >>> found = vrts.prove(".PROGRAM go()\nIF SIG(1001) THEN\nDRIVE 1, 900, 100\nEND\n.END\n")
    >>> found.answer, found.futures[0].line
    ('violated', 3)
    """
    if not isinstance(states, int) or states < 1:  # pyright: ignore[reportUnnecessaryIsInstance]
        raise VrtsError("`states` is a whole number, 1 or more")
    entry = word(entry, "entry")
    file = given(program)
    where = where_of(scene, task, scenario)
    setting = setting_read(file, scene, task, where) or found_setting(file.path, where)
    if setting is None:
        request = run_request(file, where, reading(dialect, files, "auto"), entry)
    else:
        request = verify_request(file, setting, reading(dialect, files, STRICT), entry=entry)
    around, _ = outside(request.setting, optional_path(environment), fixed=scenario is not None)
    found = proved(request, around, Asking(states=states, collisions=collisions))
    return Proof(request.title or request.program.name, proof_in(found))
