"""Marks one program in a process of its own: the worker of marking.

Where a task has hidden checks a program is marked twice, so that what students get comes from a
run of the checks that know nothing of the hidden ones.
"""

import base64
import sys
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import msgspec
from msgspec import structs

from vrts import __version__
from vrts.assignments.packed import is_packed
from vrts.assignments.task_folder import reference_of
from vrts.check.mark.earned import not_reached
from vrts.controllers.models import FIRST
from vrts.controllers.values import digest
from vrts.marking.proposer.by_name import By, by_name
from vrts.marking.proposer.kept import Kept
from vrts.marking.proposer.process import load_for_children
from vrts.marking.result import (
    SCORING,
    Damaged,
    Kind,
    OfVariant,
    Record,
    Result,
    decoded,
    key_of,
)
from vrts.marking.submission.mending import would_do
from vrts.marking.submission.one import Marked, Order, Wanted, mark, refused
from vrts.marking.submission.report_files import FAULT, RECORDING, REPORT, Reader, write_files
from vrts.marking.submission.setting import Place, load
from vrts.marking.submission.sketch import SKETCH
from vrts.marking.submission.summary import result_of, unmarked
from vrts.marking.supervise.limits import Limits, for_mending, for_states, impose
from vrts.marking.supervise.scratch import scratch_folder
from vrts.pipeline.setting import Setting
from vrts.report.audience import for_student

STUDENT, STAFF = "student", "staff"  # folders of what a process writes
MADE = "made.json"  # the results, written before what would mend a program is looked for
WRITTEN = (
    *(f"{who}/{name}" for who in (STUDENT, STAFF) for name in (REPORT, RECORDING, FAULT)),
    f"{STAFF}/{SKETCH}",
)

IDLE = b".PROGRAM warm()\nSTOP\n.END\n"


class Marks(Record, frozen=True):
    """What a process answers."""

    staff: Result
    student: Result


class Marker:
    """Marks programs by one task."""

    def __init__(self, place: Place, wanted: Wanted) -> None:
        """Read the task.

        Raises:
            CannotRead: A file is not there.
            Refused: Task, scene or scenario have errors.
        """
        self.place = place
        self.wanted = wanted
        self.whole: Setting = load(place, staff=True)
        self.public: Setting = self.whole
        if self.whole.hidden:  # students are told how many checks they do not see
            self.public = replace(load(place, staff=False), more=self.whole.hidden)
        assert self.whole.task is not None
        assert self.public.task is not None
        known = {entry.check for entry in not_reached(self.public.task)}
        every = {entry.check for entry in not_reached(self.whole.task)}
        self.hidden = frozenset(every - known)  # names of checks
        self.variant = place.variant and OfVariant(place.variant)
        self.kept: Kept | None = None  # gives second opinions to all processes, once warm

    def of(self, identifier: str) -> "Marker":
        """Return what marks the program of a student: it may have a variant of its own."""
        del identifier
        return self

    @property
    def limits(self) -> Limits:
        """What a process may use: more where a task asks for every future."""
        settings = {id(one): one for one in (self.whole, self.public, *self.whole.variants)}
        tasks = [setting.task for setting in settings.values()]
        proofs = [task.proof for task in tasks if task is not None and task.proof is not None]
        limits = for_states(sum(proof.states for proof in proofs))
        return for_mending(limits, self.wanted.mending)

    def key(self, data: bytes) -> str:
        """Return the digest of everything that the result for the staff depends on."""
        settings = (self.whole, self.public, *self.whole.variants)
        return self._key(data, settings, mending=self.wanted.mending)

    def public_key(self, data: bytes) -> str:
        """Return the same for the student: nothing of hidden checks is in it."""
        return self._key(data, (self.public,))

    def _key(self, data: bytes, settings: Iterable[Setting], mending: int = 0) -> str:
        digests: list[str] = []
        for setting in settings:
            assert setting.task is not None
            digests += [setting.task.digest, setting.scene.digest]
            if setting.scene.controller != FIRST:  # of which results did not tell
                digests += [digest(setting.scene.controller)]
        asked: dict[str, object] = msgspec.to_builtins(self.wanted)
        del asked["mending"]  # of which results did not tell
        if mending:
            asked["mending"] = mending
        wanted = msgspec.json.encode(asked).decode()
        return key_of(data, *digests, *versions_of_scoring(), wanted)

    @property
    def folder(self) -> Path:
        """The folder of the task's file."""
        path = Path(self.place.task)
        return path if path.is_dir() else path.parent

    def warm_up(self) -> None:
        """Load and draw what all submissions share, by marking the reference of the task.

        Without a reference a program that does nothing has to do. Nothing is recorded: recordings
        start threads, which must not be there when processes fork.
        """
        reference = None if is_packed(Path(self.place.task)) else reference_of(self.folder)
        program = IDLE if reference is None else reference.read_bytes()
        order = Order("warm-up", "warm-up.v2", program)
        quiet = structs.replace(self.wanted, recordings=False, mending=0)
        if self.wanted.recordings:
            from vrts.report.recording import prepare  # rerun is optional, and heavy

            prepare(self.whole.scene)
        if self.wanted.collisions:
            load_for_children()
            if sys.platform == "linux" and self.kept is None:  # who warms up forks
                limits = self.limits
                self.kept = Kept(lambda: impose(limits))
        with scratch_folder() as folder:
            self._work(order, folder, quiet)

    def rest(self) -> None:
        """End what was kept for all processes."""
        if self.kept is not None:
            self.kept.end()
        self.kept = None

    def work(self, order: Order, folder: Path) -> bytes:
        """Mark, write pages and recordings, and answer with the results."""
        return msgspec.json.encode(self._work(order, folder, self.wanted))

    def _work(self, order: Order, folder: Path, wanted: Wanted) -> Marks:
        kept = None if self.kept is None else self.kept.address
        with by_name(wanted.engine, asked=wanted.collisions, kept=kept) as by:
            staff = self._mark(order, self.whole, wanted, by)
            same = self.public is self.whole
            student = staff if same else self._mark(order, self.public, wanted, by)
        marks = self._finished(staff, student, order.data, folder, wanted)
        if not wanted.mending or staff.fault is not None:
            return marks
        (folder / MADE).write_bytes(msgspec.json.encode(marks))  # they stand, whatever follows
        mending = would_do(order, self.public, wanted.mending)
        return Marks(structs.replace(marks.staff, mending=mending), marks.student)

    def _mark(self, order: Order, setting: Setting, wanted: Wanted, by: By) -> Marked:
        return mark(order, setting, wanted, by)

    def _finished(
        self, staff: Marked, student: Marked, data: bytes | None, folder: Path, wanted: Wanted
    ) -> Marks:
        write_files(
            (staff, Reader(folder / STAFF, self.whole, grader=True)),
            (student, Reader(folder / STUDENT, self.public, grader=False)),
            wanted,
            self.hidden,
        )
        return Marks(
            self._result(staff, self.whole, data),
            self._result(student, self.public, data, student=True),
        )

    def lost(self, order: Order, sentence: str) -> Marks:
        """Return the results of an order whose process was ended."""
        hint = "mark it again on a machine with more memory, or look at the program by hand"
        return self.unmarked(Kind.RESOURCE, order.identifier, sentence, hint, order.data)

    def unmarked(
        self, kind: Kind, identifier: str, sentence: str, hint: str | None, data: bytes = b""
    ) -> Marks:
        """Return the results of a submission that has no mark."""
        staff = unmarked(kind, identifier, sentence, hint, self.whole, self.key(data))
        student = unmarked(kind, identifier, sentence, hint, self.public, self.public_key(data))
        return Marks(self._of_variant(staff), self._of_variant(student))

    def refused(self, identifier: str, title: str, sentence: str, folder: Path) -> Marks:
        """Return the results of a file that is no program, and write its pages."""
        row = refused(identifier, title, sentence, self.public)
        return self._finished(row, row, None, folder, self.wanted)

    def command(self, order: Order, folder: Path) -> tuple[list[str], bytes]:
        """Return the same as a command, for systems where nothing is forked."""
        told = Told(
            self.place,
            self.wanted,
            order.identifier,
            order.title,
            base64.b64encode(order.data).decode(),
            str(folder),
        )
        return [sys.executable, "-m", "vrts.marking.submission.alone"], msgspec.json.encode(told)

    def _result(
        self, row: Marked, setting: Setting, data: bytes | None, *, student: bool = False
    ) -> Result:
        a = for_student(row.assessment) if student else row.assessment
        hidden = () if student else self.hidden
        key = (self.public_key if student else self.key)(data or b"")
        if row.fault is not None:
            found = self._of_variant(result_of(a, setting, data, key, hidden))
            return structs.replace(found, kind=Kind.FAULT, mark=None, review=(found.cause,))
        return self._of_variant(result_of(a, setting, data, key, hidden))

    def _of_variant(self, result: Result) -> Result:
        return structs.replace(result, variant=self.variant) if self.variant else result


class Told(Record, frozen=True):
    """What a process that is started anew is told."""

    place: Place
    wanted: Wanted
    identifier: str
    title: str
    program: str  # in base64
    folder: str


def read_marks(data: bytes) -> Marks:
    """Return the results that a process answered with.

    Raises:
        Damaged: They are none.
    """
    return decoded(data, Marks)


def made_before(folder: Path) -> Marks | None:
    """Return the results that a process had made when it began to look for what would mend.

    None: it had not come so far.
    """
    try:
        return read_marks((folder / MADE).read_bytes())
    except (OSError, Damaged):
        return None


def versions_of_scoring() -> tuple[str, str]:
    """Return the versions that results depend on: of vrts and of the scoring."""
    return __version__, str(SCORING)
